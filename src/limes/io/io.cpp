#include "limes/io/io.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <limits>
#include <memory>
#include <system_error>
#include <utility>

#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/text.h"
#include "limes/io/whole_file.h"

namespace limes {

namespace fs = std::filesystem;

const std::array<Format, 5> all_formats{{
    {"Wavefront OBJ", ".obj", read_obj, write_obj, true, true,
     "polygons, relative indices, OpenSubdiv tags, groups (g), parts (o); no textures, materials, "
     "curves, hierarchical edits",
     "polygons, tags, groups, parts; shortest exact decimals"},
    {"Geomview OFF", ".off", read_off, write_off, false, false,
     "polygons; OFF, COFF, NOFF, STOFF or no keyword; colours and normals ignored; no binary",
     "polygons; shortest exact decimals"},
    {"Stanford PLY", ".ply", read_ply, write_ply, false, false,
     "polygons; text and both binary orders, every number type; other elements ignored",
     "polygons; binary little endian, doubles"},
    {"STL", ".stl", read_stl, write_stl, false, false,
     "triangles; text and binary; vertices welded where positions are equal",
     "triangles (polygons become fans); binary, single precision"},
    {"VTK unstructured grid", ".vtu", nullptr, write_vtu, false, false, "",
     "polygons; doubles, zlib"},
}};

namespace {

std::string extension_of(const fs::path& file) {
  return to_lower(file.extension().string());
}

/// The format of that extension, or nothing.
const Format* find_format(const fs::path& file) {
  const auto format = std::find_if(all_formats.begin(), all_formats.end(), [&](const Format& f) {
    return f.extension == extension_of(file);
  });
  return format == all_formats.end() ? nullptr : &*format;
}

}  // namespace

void require_file(const fs::path& path) {
  const std::string name = path.string();
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) throw InputError("{}: no such file", name);
  if (error) throw InputError("{}: cannot be read: {}", name, error.message());
  if (fs::is_directory(status)) throw InputError("{}: is a directory; a mesh file is right", name);
  if (!fs::is_regular_file(status)) throw InputError("{}: is no regular file", name);
}

std::string read_bytes(const fs::path& path) {
  const std::string name = path.string();
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(name.c_str(), "rb"),
                                                             std::fclose);
  if (!file) throw InputError("{}: {}", name, std::generic_category().message(errno));
  std::string bytes;
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  try {
    bytes.resize(error ? 0 : static_cast<std::size_t>(size));
  } catch (const std::exception&) {  // bad_alloc or length_error
    throw InputError("{}: {} bytes do not fit into memory", name, size);
  }
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file.get()));
  if (error || std::ferror(file.get()) != 0) throw InputError("{}: cannot be read", name);
  return bytes;
}

namespace {

/// A file without faces could not be read again.
void check_faces(const fs::path& file, const Format& format, const Mesh& mesh) {
  const auto num_faces = static_cast<std::size_t>(mesh.topology.num_faces());
  if (!format.tags && num_faces > 0 && mesh.tags.holes.size() == num_faces)
    throw OutputError("{}: cannot be written: every face is a hole, and {} keeps no hole tags",
                      file.string(), format.name);
}

void check_coordinates(const fs::path& file, const Format& format, const Mesh& mesh) {
  const double largest = format.write == write_stl ? std::numeric_limits<float>::max()
                                                   : std::numeric_limits<double>::max();
  for (int v = 0; v < mesh.points.size(); ++v)
    if (!(mesh.points[VertexId(v)].cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <= largest))
      throw OutputError("{}: cannot be written: vertex {} has a coordinate that is too large",
                        file.string(), v);
}

/// The faces that are not holes; all vertices stay.
Mesh without_holes(const Mesh& mesh) {
  std::vector<bool> hole(static_cast<std::size_t>(mesh.topology.num_faces()), false);
  for (const FaceId f : mesh.tags.holes)
    hole[static_cast<std::size_t>(f.value)] = true;
  std::vector<int> offsets{0};
  std::vector<VertexId> corners;
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    if (hole[static_cast<std::size_t>(f)]) continue;
    const auto face = mesh.topology.face(FaceId(f));
    corners.insert(corners.end(), face.begin(), face.end());
    offsets.push_back(static_cast<int>(corners.size()));
  }
  Mesh result;
  result.topology = Topology(mesh.topology.num_vertices(), std::move(offsets), std::move(corners));
  result.points = mesh.points;
  return result;
}

/// "2 creases and 1 corner": of two kinds those that are there.
std::string both(std::size_t a, std::string_view one_a, std::string_view many_a, std::size_t b,
                 std::string_view one_b, std::string_view many_b) {
  if (b == 0) return counted(a, one_a, many_a);
  if (a == 0) return counted(b, one_b, many_b);
  return counted(a, one_a, many_a) + " and " + counted(b, one_b, many_b);
}

std::vector<std::string> losses(const fs::path& file, const Format& format, const Mesh& mesh) {
  std::vector<std::string> remarks;
  const auto add = [&](std::string what) {
    remarks.push_back(fmt::format("{}: {}", file.string(), what));
  };
  const Tags& tags = mesh.tags;
  if (!format.tags && !tags.holes.empty())
    add(fmt::format("{} keeps no hole tags; {} left out", format.name,
                    counted(tags.holes.size(), "hole face", "hole faces")));
  if (!format.tags && tags.creases.size() + tags.corners.size() > 0)
    add(fmt::format(
        "{} keeps no sharpness; {} lost", format.name,
        both(tags.creases.size(), "crease", "creases", tags.corners.size(), "corner", "corners")));
  if (!format.tags &&
      (tags.boundary || tags.smooth_triangles || tags.crease_method != CreaseMethod::uniform))
    add(fmt::format("{} keeps no rules of subdivision; those of the file lost", format.name));
  if (!format.names && mesh.groups.size() + mesh.parts.size() > 0)
    add(fmt::format(
        "{} keeps no names; {} lost", format.name,
        both(mesh.groups.size(), "group", "groups", mesh.parts.size(), "part", "parts")));
  if (format.write == write_stl)
    add("STL holds triangles in single precision; polygons cut into fans, coordinates rounded");
  return remarks;
}

}  // namespace

MeshFile read_mesh(const fs::path& file) {
  require_file(file);
  const Format* const format = find_format(file);
  if (!format || !format->read)
    throw InputError("{}: meshes of type {} cannot be read; .obj, .off, .ply and .stl can",
                     file.string(), quote(extension_of(file)));
  return format->read(read_bytes(file), file.string());
}

std::vector<std::string> write_mesh(const fs::path& path, const Mesh& mesh, AtomicFiles& files) {
  const Format* const format = find_format(path);
  if (!format || !format->write)
    throw UsageError("{}: meshes of type {} cannot be written; .obj, .off, .ply, .stl and .vtu can",
                     path.string(), quote(extension_of(path)));
  check_faces(path, *format, mesh);
  check_coordinates(path, *format, mesh);
  AtomicFile& file = files.add(path);
  const ByteSink sink = [&](std::string_view bytes) {
    check_interrupt();
    file.write(bytes);
  };
  if (format->tags || mesh.tags.holes.empty())
    format->write(sink, mesh);
  else
    format->write(sink, without_holes(mesh));
  return losses(path, *format, mesh);
}

std::vector<std::string> write_mesh(const fs::path& path, const Mesh& mesh) {
  AtomicFiles files;
  std::vector<std::string> lost = write_mesh(path, mesh, files);
  files.commit();
  return lost;
}

}  // namespace limes
