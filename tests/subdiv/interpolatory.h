#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "limes/core/error.h"
#include "limes/mesh/mesh.h"

namespace limes {

// Nets refined by a program that is not ours, see tests/data/interpolatory/README.md.

inline nlohmann::json read_interpolatory(const std::string& name) {
  const std::string file = std::string(LIMES_TEST_DATA_DIR) + "/interpolatory/" + name + ".json";
  std::ifstream in(file);
  if (!in) throw InputError("{}: cannot be read", file);
  return nlohmann::json::parse(in);
}

inline Mesh net_of(const nlohmann::json& level) {
  Mesh mesh;
  for (const auto& x : level.at("V"))
    mesh.points.push_back(Vec3(x[0].get<double>(), x[1].get<double>(), x[2].get<double>()));
  std::vector<VertexId> corners;
  for (const auto& face : level.at("F"))
    for (const auto& v : face)
      corners.emplace_back(v.get<int>());
  mesh.topology = Topology(mesh.points.size(), 4, std::move(corners));
  return mesh;
}

/// The control net of a golden file with its breakpoints as corners.
inline Mesh control_net(const nlohmann::json& golden) {
  Mesh mesh = net_of(golden);
  for (const auto& v : golden.at("breakpoints"))
    mesh.tags.corners.push_back({VertexId(v.get<int>()), infinite_sharpness});
  return mesh;
}

inline double size_of(const Mesh& mesh) {
  double size = 0;
  for (const Vec3& x : mesh.points)
    size = std::max(size, x.norm());
  return size;
}

}  // namespace limes
