#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "limes/core/error.h"
#include "limes/io/io.h"

namespace limes {

using Faces = std::vector<std::vector<int>>;
using Points = std::vector<std::vector<double>>;

inline Faces faces_of(const Mesh& mesh) {
  Faces faces;
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    faces.emplace_back();
    for (const VertexId v : mesh.topology.face(FaceId(f)))
      faces.back().push_back(v.value);
  }
  return faces;
}

inline Points points_of(const Mesh& mesh) {
  Points points;
  for (const Vec3& x : mesh.points)
    points.push_back({x[0], x[1], x[2]});
  return points;
}

/// "a: 0 2; b: 1" of groups or parts.
inline std::string names_of(const std::vector<FaceGroup>& groups) {
  std::string text;
  for (const FaceGroup& g : groups) {
    text += fmt::format("{}{}:", text.empty() ? "" : "; ", g.name);
    for (const FaceId f : g.faces)
      text += fmt::format(" {}", f.value);
  }
  return text;
}

using Reader = MeshFile (*)(std::string_view, std::string_view);

/// The message with which a reader refuses a text; empty when it takes it.
inline std::string refusal(Reader read, std::string_view text) {
  try {
    static_cast<void>(read(text, "f"));
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

/// Everything a writer puts down.
inline std::string written(void (*write)(const ByteSink&, const Mesh&), const Mesh& mesh) {
  std::string bytes;
  write([&](std::string_view piece) { bytes += piece; }, mesh);
  return bytes;
}

}  // namespace limes
