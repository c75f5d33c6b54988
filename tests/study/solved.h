#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "convergence/plane_meshes.h"
#include "limes/core/error.h"
#include "limes/study/checks.h"
#include "limes/study/probes.h"

namespace limes {

/// A problem from the rest of its file, on the mesh "m.obj".
inline Problem problem_of(const std::string& text) {
  return parse_problem("[mesh]\nfile = \"m.obj\"\n" + text, "p.toml");
}

struct Solved {
  PlaneModel model;
  PlaneSolution solution;
  std::vector<ProbeResult> probes;
};

/// Solves it on this mesh; the solution's own checks must pass.
inline Solved solve(const std::string& text, Mesh mesh) {
  Solved s{build_model(problem_of(text), std::move(mesh)), {}, {}};
  s.solution = solve_plane(s.model);
  s.probes = probe(s.model, s.solution);
  for (const SolutionCheck& c : check_solution(s.model, s.solution))
    EXPECT_TRUE(c.passed()) << c.name << ' ' << c.value;
  return s;
}

/// What is wrong with it; "no error".
inline std::string message_of(const std::string& text, Mesh mesh) {
  try {
    (void)solve_plane(build_model(problem_of(text), std::move(mesh)));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

inline const std::string steel = "[material]\nyoung = 3.0\npoisson = 0.25\nthickness = 0.5\n";

}  // namespace limes
