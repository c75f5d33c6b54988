#include "limes/study/adapt_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <type_traits>

#include "limes/core/atomic_file.h"
#include "limes/core/error.h"
#include "limes/study/control_mesh.h"

namespace limes {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Leaf = std::array<std::int64_t, 3>;  // root, level, path

constexpr const char* kind = "limes adaptive run 2";

/// 64-bit FNV-1a; lists begin with their length.
class Digest {
 public:
  template <class Number>
  void add(Number value) {
    static_assert(std::is_arithmetic_v<Number>);
    add_bytes(&value, sizeof value);
  }
  template <class Id>
  void add_ids(const std::vector<Id>& ids) {
    add(ids.size());
    for (const Id id : ids)
      add(id.value);
  }
  void add_groups(const std::vector<FaceGroup>& groups) {
    add(groups.size());
    for (const FaceGroup& g : groups) {
      add(g.name.size());
      add_bytes(g.name.data(), g.name.size());
      add_ids(g.faces);
    }
  }
  [[nodiscard]] std::string text() const { return fmt::format("{:016x}", hash_); }

 private:
  void add_bytes(const void* bytes, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i)
      hash_ = (hash_ ^ static_cast<const unsigned char*>(bytes)[i]) * 1099511628211ULL;
  }
  std::uint64_t hash_ = 14695981039346656037ULL;
};

void add_tags(const Tags& tags, Digest& digest) {
  digest.add(tags.creases.size());
  for (const CreaseTag& c : tags.creases) {
    digest.add(c.a.value);
    digest.add(c.b.value);
    digest.add(c.sharpness);
  }
  digest.add(tags.corners.size());
  for (const CornerTag& c : tags.corners) {
    digest.add(c.vertex.value);
    digest.add(c.sharpness);
  }
  digest.add_ids(tags.holes);
  digest.add(tags.boundary ? static_cast<int>(*tags.boundary) : -1);
  digest.add(static_cast<int>(tags.crease_method));
  digest.add(tags.smooth_triangles);
}

/// Of all that a result may depend on: corners of the quads, points, tags, groups and parts.
std::string digest(const Mesh& mesh) {
  Digest out;
  out.add(mesh.topology.num_corners());
  for (const VertexId v : mesh.topology.corners())
    out.add(v.value);
  for (const Vec3& x : mesh.points)
    for (const double coordinate : x)
      out.add(coordinate);
  add_tags(mesh.tags, out);
  out.add_groups(mesh.groups);
  out.add_groups(mesh.parts);
  return out.text();
}

/// What must be the same: all but the title and when the loop ends.
std::vector<std::string> settings(const Problem& problem) {
  std::vector<std::string> out;
  for (const std::string& value : problem.values) {
    const std::string key = value.substr(0, value.find(' '));
    if (key != "title" && key != "adapt.target_error" && key != "adapt.max_dofs" &&
        key != "adapt.max_steps" && key != "adapt.max_seconds")
      out.push_back(value);
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<Leaf> leaves_of(const Forest& forest) {
  std::vector<Leaf> out;
  for (const FaceId leaf : forest.leaves()) {
    const FaceAncestry a = forest.ancestry(leaf);
    out.push_back({a.root.value, a.level, a.path});
  }
  return out;
}

Json step_json(const AdaptStep& s) {
  Json out{{"dofs", s.dofs},
           {"elements", s.elements},
           {"strain_energy", s.strain_energy},
           {"error_estimate", s.error_estimate},
           {"relative_error", s.relative_error}};
  if (s.true_error) out["true_error"] = *s.true_error;
  if (s.effectivity) out["effectivity"] = *s.effectivity;
  if (s.finer_error) out["finer_error"] = *s.finer_error;
  if (s.finer_effectivity) out["finer_effectivity"] = *s.finer_effectivity;
  return out;
}

/// -1 if it is no positive integer.
int positive(const Json& json) {
  if (!json.is_number_integer()) return -1;
  const auto n = json.get<std::int64_t>();
  return n > 0 && n <= std::numeric_limits<int>::max() ? static_cast<int>(n) : -1;
}

AdaptStep step_of(const Json& json) {
  AdaptStep s;
  s.dofs = positive(json.at("dofs"));
  s.elements = positive(json.at("elements"));
  s.strain_energy = json.at("strain_energy").get<double>();
  s.error_estimate = json.at("error_estimate").get<double>();
  s.relative_error = json.at("relative_error").get<double>();
  if (json.contains("true_error")) s.true_error = json["true_error"].get<double>();
  if (json.contains("effectivity")) s.effectivity = json["effectivity"].get<double>();
  if (json.contains("finer_error")) s.finer_error = json["finer_error"].get<double>();
  if (json.contains("finer_effectivity"))
    s.finer_effectivity = json["finer_effectivity"].get<double>();
  return s;
}

/// Whether a step can be one of a run with these targets.
/// @param finer  whether steps are compared with finer solutions
bool is_possible(const AdaptStep& s, const AdaptTargets& targets, bool finer) {
  const auto is_error = [](double x) { return std::isfinite(x) && x >= 0; };
  return s.dofs > 0 && s.elements > 0 && std::isfinite(s.strain_energy) &&
         is_error(s.error_estimate) && is_error(s.relative_error) &&
         s.true_error.has_value() == targets.reference_energy.has_value() &&
         is_error(s.true_error.value_or(0)) && is_error(s.effectivity.value_or(0)) &&
         s.effectivity.has_value() == (s.true_error.value_or(0) > 0) &&
         s.finer_error.has_value() == finer && is_error(s.finer_error.value_or(0)) &&
         is_error(s.finer_effectivity.value_or(0)) &&
         s.finer_effectivity.has_value() == (s.finer_error.value_or(0) > 0);
}

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw InputError("{}: {}; run without --resume", file.string(), why);
}

Json read_state(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) refuse(file, "there is no run to resume, the file cannot be read");
  try {
    Json state = Json::parse(in);
    if (state.at("kind") != kind) refuse(file, "is of another kind or version");
    return state;
  } catch (const Json::exception&) {
    refuse(file, "is damaged");
  }
}

void require_same_problem(const Problem& problem, const std::vector<std::string>& there) {
  const std::vector<std::string> here = settings(problem);
  const auto first_only_in = [](const auto& a, const auto& b) {
    std::vector<std::string> only;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(only));
    return only.empty() ? std::string("nothing") : "'" + only.front() + "'";
  };
  if (there == here) return;
  refuse(problem.adapt->state,
         fmt::format("is of another problem, it has {} where {} has {}", first_only_in(there, here),
                     problem.file.string(), first_only_in(here, there)));
}

void require_not_ended(const fs::path& file, const AdaptTargets& targets) {
  for (std::size_t i = 0; i < targets.before.size(); ++i) {
    if (targets.error && targets.before[i].relative_error <= *targets.error)
      refuse(file, fmt::format("has gone beyond step {}, at which target_error is reached", i));
    if (static_cast<int>(i) + 1 >= targets.max_steps)
      refuse(file, fmt::format("has gone beyond step {}, the last of max_steps", i));
  }
}

/// Splits what was split; balance asks for nothing else, because the leaves were balanced.
void restore(Forest& forest, const std::vector<Leaf>& leaves, const fs::path& file) {
  std::set<Leaf> split;
  for (const Leaf& leaf : leaves) {
    if (leaf[1] > Forest::max_level) refuse(file, "is damaged");
    for (Leaf above = leaf; above[1] > 0;) {
      above = {above[0], above[1] - 1, above[2] >> 2};
      if (!split.insert(above).second) break;
    }
  }
  for (std::vector<FaceId> wanted;; wanted.clear()) {
    for (const FaceId leaf : forest.leaves()) {
      const FaceAncestry a = forest.ancestry(leaf);
      if (split.count({a.root.value, a.level, a.path}) != 0) wanted.push_back(leaf);
    }
    if (wanted.empty()) break;
    forest.refine(wanted);
  }
  if (leaves_of(forest) != leaves) refuse(file, "is damaged");
}

void resume(const Problem& problem, Forest& forest, const std::string& mesh,
            AdaptTargets& targets) {
  const fs::path& file = problem.adapt->state;
  const Json state = read_state(file);
  std::vector<Leaf> leaves;
  try {
    require_same_problem(problem, state.at("problem").get<std::vector<std::string>>());
    if (state.at("mesh") != mesh)
      refuse(file, fmt::format("was started on another mesh than {}", mesh_path(problem).string()));
    for (const Json& step : state.at("steps")) {
      targets.before.push_back(step_of(step));
      if (!is_possible(targets.before.back(), targets, problem.adapt->reference_levels > 0))
        refuse(file, "is damaged");
    }
    leaves = state.at("leaves").get<std::vector<Leaf>>();
  } catch (const Json::exception&) {
    refuse(file, "is damaged");
  }
  require_not_ended(file, targets);
  restore(forest, leaves, file);
  if (has_too_many_dofs(forest_mesh(forest, targets.closure), targets))
    refuse(file, "has gone beyond max_dofs");
}

}  // namespace

void keep_state(const Problem& problem, Forest& forest, AdaptTargets& targets) {
  if (problem.adapt->state.empty()) return;
  const std::string mesh = digest(forest.control());
  if (problem.adapt->resume) resume(problem, forest, mesh, targets);
  targets.on_refined = [file = problem.adapt->state, mesh, values = settings(problem)](
                           const std::vector<AdaptStep>& steps, const Forest& refined) {
    Json state{{"kind", kind}, {"problem", values}, {"mesh", mesh}};
    state["steps"] = Json::array();
    for (const AdaptStep& step : steps)
      state["steps"].push_back(step_json(step));
    state["leaves"] = leaves_of(refined);
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    if (error)
      throw OutputError("{}: cannot be made: {}", file.parent_path().string(), error.message());
    AtomicFile out(file);
    out.write(state.dump() + "\n");
    out.commit();
  };
}

}  // namespace limes
