#include "limes/io/vtu.h"

#include <zlib.h>

#include <algorithm>
#include <memory>
#include <span>
#include <string_view>
#include <utility>

#include "limes/core/atomic_file.h"
#include "limes/core/error.h"
#include "limes/core/parallel.h"
#include "limes/io/bytes.h"
#include "limes/io/chunk_writer.h"

namespace limes {
namespace {

constexpr std::size_t block_size = 1 << 20;
constexpr int compression_level = 1;  // 5 uses three times the time for 4 % less

std::string compress_block(std::string_view bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string result(size, '\0');
  const int status = compress2(reinterpret_cast<Bytef*>(result.data()), &size,
                               reinterpret_cast<const Bytef*>(bytes.data()),
                               static_cast<uLong>(bytes.size()), compression_level);
  LIMES_ASSERT(status == Z_OK);
  result.resize(size);
  return result;
}

void append_number(std::string& bytes, auto value) {
  const auto raw = number_bytes(value);
  bytes.append(raw.data(), raw.size());
}

/// VTK's layout of compressed data: number of blocks, size of a block, size of the last one if it
/// is shorter (else 0), compressed sizes; then the blocks.
std::string compress(std::string_view bytes) {
  const std::size_t num_blocks = (bytes.size() + block_size - 1) / block_size;
  std::vector<std::string> blocks(num_blocks);
  for_each_block(static_cast<std::int64_t>(num_blocks), 1,
                 [&](std::int64_t begin, std::int64_t end) {
                   for (std::int64_t i = begin; i < end; ++i) {
                     const auto b = static_cast<std::size_t>(i);
                     blocks[b] = compress_block(bytes.substr(b * block_size, block_size));
                   }
                 });
  std::string result;
  append_number(result, std::uint64_t{num_blocks});
  append_number(result, std::uint64_t{block_size});
  append_number(result, std::uint64_t{bytes.size() % block_size});
  for (const std::string& block : blocks)
    append_number(result, std::uint64_t{block.size()});
  for (const std::string& block : blocks)
    result += block;
  return result;
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

/// Builds the XML head and the appended data side by side: the head needs the data's offsets.
class VtuWriter {
 public:
  explicit VtuWriter(const VtuGrid& grid) : grid_(grid) {}
  void write(const ByteSink& sink);

 private:
  void check() const;
  void add_points();
  void add_cells();
  void add_data(std::string_view section, std::string_view attribute,
                const std::vector<VtuArray>& arrays, std::size_t num_entries);
  void add_array(const VtuArray& array, std::size_t num_entries);
  template <class T>
  void add_values(std::string_view name, int components, std::span<const T> values);
  template <class... Args>
  void print(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(head_), format, std::forward<Args>(args)...);
  }

  const VtuGrid& grid_;
  std::string head_, data_;
};

void VtuWriter::check() const {
  LIMES_ASSERT(grid_.offsets.size() == grid_.types.size());
  LIMES_ASSERT(grid_.degrees.empty() || grid_.degrees.size() == grid_.types.size());
  LIMES_ASSERT(grid_.rational_weights.empty() ||
               grid_.rational_weights.size() == grid_.points.size());
  const auto last = grid_.offsets.empty() ? 0 : grid_.offsets.back();
  LIMES_ASSERT(last == static_cast<std::int64_t>(grid_.connectivity.size()));
}

template <class T>
constexpr std::string_view type_name() {
  if constexpr (std::is_same_v<T, double>) return "Float64";
  if constexpr (std::is_same_v<T, std::int64_t>) return "Int64";
  return "UInt8";
}

template <class T>
void VtuWriter::add_values(std::string_view name, int components, std::span<const T> values) {
  print(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
      "offset=\"{}\"/>\n",
      type_name<T>(), escaped(name), components, data_.size());
  std::string bytes;
  bytes.reserve(values.size_bytes());
  for (const T value : values)
    append_number(bytes, value);
  data_ += compress(bytes);
}

void VtuWriter::add_points() {
  std::vector<double> coordinates;
  coordinates.reserve(3 * grid_.points.size());
  for (const Vec3& x : grid_.points)
    coordinates.insert(coordinates.end(), {x[0], x[1], x[2]});
  print("<Points>\n");
  add_values<double>("Points", 3, coordinates);
  print("</Points>\n");
}

void VtuWriter::add_cells() {
  std::vector<std::uint8_t> types;
  for (const VtkCell type : grid_.types)
    types.push_back(static_cast<std::uint8_t>(type));
  print("<Cells>\n");
  add_values<std::int64_t>("connectivity", 1, grid_.connectivity);
  add_values<std::int64_t>("offsets", 1, grid_.offsets);
  add_values<std::uint8_t>("types", 1, types);
  print("</Cells>\n");
}

void VtuWriter::add_array(const VtuArray& array, std::size_t num_entries) {
  const auto add = [&]<class T>(const std::vector<T>& values) {
    LIMES_ASSERT(values.size() == num_entries * static_cast<std::size_t>(array.components));
    add_values<T>(array.name, array.components, values);
  };
  std::visit(add, array.values);
}

void VtuWriter::add_data(std::string_view section, std::string_view attribute,
                         const std::vector<VtuArray>& arrays, std::size_t num_entries) {
  print("<{}{}>\n", section, attribute);
  for (const VtuArray& array : arrays)
    add_array(array, num_entries);
  print("</{}>\n", section);
}

VtuArray degree_array(const std::vector<int>& degrees) {
  std::vector<double> values;
  for (const int p : degrees)
    values.insert(values.end(), {double(p), double(p), 0.0});
  return {"HigherOrderDegrees", 3, std::move(values)};
}

void VtuWriter::write(const ByteSink& sink) {
  check();
  print(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<UnstructuredGrid>\n"
      "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
      grid_.points.size(), grid_.types.size());
  add_points();
  add_cells();
  // VTK finds weights and degrees by an attribute that names the array
  auto point_data = grid_.point_data;
  std::string_view weights, degrees;
  if (!grid_.rational_weights.empty()) {
    point_data.push_back({"RationalWeights", 1, grid_.rational_weights});
    weights = " RationalWeights=\"RationalWeights\"";
  }
  auto cell_data = grid_.cell_data;
  if (!grid_.degrees.empty()) {
    cell_data.push_back(degree_array(grid_.degrees));
    degrees = " HigherOrderDegrees=\"HigherOrderDegrees\"";
  }
  add_data("PointData", weights, point_data, grid_.points.size());
  add_data("CellData", degrees, cell_data, grid_.types.size());
  print("</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_");
  sink(head_);
  sink(data_);
  sink("\n</AppendedData>\n</VTKFile>\n");
}

}  // namespace

void VtuGrid::add_cell(VtkCell type, std::span<const std::int64_t> cell_points) {
  connectivity.insert(connectivity.end(), cell_points.begin(), cell_points.end());
  offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  types.push_back(type);
}

void write_vtu(const ByteSink& sink, const VtuGrid& grid) {
  VtuWriter(grid).write(sink);
}

void write_vtu(const std::filesystem::path& path, const VtuGrid& grid) {
  AtomicFile file(path);
  write_vtu([&](std::string_view bytes) { file.write(bytes); }, grid);
  file.commit();
}

void write_vtu(const ByteSink& sink, const Mesh& mesh) {
  VtuGrid grid;
  grid.points = mesh.points.vector();
  std::vector<std::int64_t> cell;
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    cell.clear();
    for (const VertexId v : mesh.topology.face(FaceId(f)))
      cell.push_back(v.value);
    grid.add_cell(cell.size() == 3   ? VtkCell::triangle
                  : cell.size() == 4 ? VtkCell::quad
                                     : VtkCell::polygon,
                  cell);
  }
  for (const FaceField& field : mesh.face_fields)
    grid.cell_data.push_back({field.name, 1, field.values});
  write_vtu(sink, grid);
}

std::vector<std::array<int, 2>> vtk_quad_points(int p) {
  std::vector<std::array<int, 2>> points{{0, 0}, {p, 0}, {p, p}, {0, p}};
  for (int i = 1; i < p; ++i)
    points.push_back({i, 0});
  for (int j = 1; j < p; ++j)
    points.push_back({p, j});
  for (int i = 1; i < p; ++i)
    points.push_back({i, p});
  for (int j = 1; j < p; ++j)
    points.push_back({0, j});
  for (int j = 1; j < p; ++j)
    for (int i = 1; i < p; ++i)
      points.push_back({i, j});
  return points;
}

std::vector<std::array<int, 2>> vtk_triangle_points(int degree) {
  std::vector<std::array<int, 2>> points;
  int low = 0;  // the current triangle has its first corner at (low, low)
  for (int p = degree; p >= 0; p -= 3, ++low) {
    if (p == 0) {
      points.push_back({low, low});
      break;
    }
    const std::array<std::array<int, 2>, 3> corner{{{low, low}, {low + p, low}, {low, low + p}}};
    points.insert(points.end(), corner.begin(), corner.end());
    for (std::size_t e = 0; e < 3; ++e) {
      const auto &from = corner[e], &to = corner[(e + 1) % 3];
      for (int k = 1; k < p; ++k)
        points.push_back(
            {from[0] + (to[0] - from[0]) / p * k, from[1] + (to[1] - from[1]) / p * k});
    }
  }
  return points;
}

}  // namespace limes
