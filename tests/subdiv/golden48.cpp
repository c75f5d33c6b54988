#include "subdiv/golden48.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace limes::golden48 {
namespace {

using Json = nlohmann::json;

State state_of(const Json& json) {
  State state;
  for (const Json& p : json.at("P"))
    state.mesh.points.push_back(Vec3(p.at(0), p.at(1), p.at(2)));
  std::vector<int> offsets{0};
  std::vector<VertexId> corners;
  for (const Json& face : json.at("F")) {
    for (const Json& v : face)
      corners.emplace_back(v.get<int>());
    offsets.push_back(static_cast<int>(corners.size()));
  }
  state.mesh.topology = Topology(state.mesh.points.size(), std::move(offsets), std::move(corners));
  for (const Json& e : json.value("tagged_edges", Json::array())) {
    state.tagged_edges.push_back({e.at(0), e.at(1)});
    state.mesh.tags.creases.push_back(
        {VertexId(e.at(0).get<int>()), VertexId(e.at(1).get<int>()), infinite_sharpness});
  }
  for (const Json& v : json.value("tagged_vertices", Json::array())) {
    state.tagged_vertices.push_back(v);
    state.mesh.tags.corners.push_back({VertexId(v.get<int>()), infinite_sharpness});
  }
  std::sort(state.tagged_edges.begin(), state.tagged_edges.end());
  state.unsplit_faces = json.value("unsplit_faces", 0);
  return state;
}

}  // namespace

std::vector<File> read(const std::string& prefix) {
  std::vector<File> files;
  for (const auto& entry : std::filesystem::directory_iterator(LIMES_TEST_DATA_DIR "/quasi48")) {
    const std::string name = entry.path().stem().string();
    if (!name.starts_with(prefix) || entry.path().extension() != ".json") continue;
    std::ifstream stream(entry.path());
    const Json json = Json::parse(stream);
    File file{name, state_of(json.at("input")), {}};
    for (const auto& [steps, state] : json.at("after").items())
      file.after.emplace_back(std::stoi(steps), state_of(state));
    files.push_back(std::move(file));
  }
  std::sort(files.begin(), files.end(),
            [](const File& a, const File& b) { return a.name < b.name; });
  return files;
}

}  // namespace limes::golden48
