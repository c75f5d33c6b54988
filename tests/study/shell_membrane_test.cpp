// Assumed membrane strains against published values, and thin warped shells against limits of the theory.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <tuple>

#include "limes/study/run.h"

namespace limes {
namespace {

ShellResult solve_file(const std::string& name, const std::vector<std::string>& overrides) {
  return run_shell_problem(read_problem(std::filesystem::path(LIMES_DATA_DIR) / name, overrides));
}

Vec3 displacement(const std::string& name, const std::vector<std::string>& overrides) {
  return solve_file(name, overrides).probes.front().displacement;
}

// [ko_2017] tables 10 and 8, "MITC4+" on the regular 16 x 16 meshes.
TEST(AssumedMembrane, PublishedRoofAndCylinder) {
  EXPECT_NEAR(-displacement("roof.toml", {"model.membrane=assumed"}).z() / 0.3024, 0.9973, 0.002);
  EXPECT_NEAR(-displacement("pinched_cylinder.toml", {"model.membrane=assumed"}).z() / 1.8248e-5,
              0.9313, 0.002);
}

// Energies of Reissner-Mindlin theory with hard ends, 32 x 64 elements, oblique to the generators.
TEST(AssumedMembrane, ThinRoofWithAHole) {
  for (const auto& [thickness, limit] : {std::pair("0.25", 1401.0685), std::pair("0.025", 72685.37),
                                         std::pair("0.0025", 4.16294e6)}) {
    const std::string thin = std::string("material.thickness=") + thickness;
    const auto error = [&](const char* membrane) {
      return 1 - solve_file("hole_5.toml",
                            {thin, "mesh.levels=3", std::string("model.membrane=") + membrane})
                         .solution.strain_energy /
                     limit;
    };
    EXPECT_LT(std::abs(error("assumed")), 0.02) << thickness;
    EXPECT_GT(error("displacement"), 2 * error("assumed")) << thickness;
  }
}

TEST(AssumedMembrane, HyparAndHemisphereAreNoWorse) {
  for (const auto& [thickness, deflected] :
       {std::pair("0.01", 9.3355e-5), std::pair("0.001", 6.3941e-3),
        std::pair("0.0001", 0.52988)}) {
    const std::string thin = std::string("material.thickness=") + thickness;
    EXPECT_NEAR(-displacement("hypar.toml", {thin, "model.membrane=assumed"}).z() / deflected, 1,
                0.03)
        << thickness;
  }
  EXPECT_NEAR(displacement("hemisphere.toml", {"model.membrane=assumed"}).x() / 0.0924131, 1,
              0.003);
}

/// Of the tip along the force, over the value of beam theory.
double tip(const std::string& mesh, bool thin, const std::string& membrane, const char* levels,
           bool in_plane = true) {
  const Vec3 u = displacement(
      "twisted_beam.toml",
      {"mesh.file=" + mesh, std::string("mesh.levels=") + levels, "model.membrane=" + membrane,
       thin ? "material.thickness=0.0032" : "material.thickness=0.32",
       in_plane ? "load.0.force_per_length=[0, 0, \"1 / 1.1\"]"
                : "load.0.force_per_length=[0, \"1 / 1.1\", 0]"});
  const double load = thin ? 1e6 : 1;  // the thin beam's values are those of a force of 1e-6
  return in_plane ? u.z() / load / (thin ? 5.256e-3 : 5.424535e-3)
                  : u.y() / load / (thin ? 1.294e-3 : 1.753248e-3);
}

// Zupan, Saje 2004 for the thick beam; the thin one as quoted in the sources of FinEtools.
TEST(TwistedBeam, AlongItsRulingsNothingLocks) {
  for (const char* membrane : {"displacement", "assumed"})
    for (const bool thin : {false, true})
      for (const bool in_plane : {false, true})
        EXPECT_NEAR(tip("twisted_beam.obj", thin, membrane, "2", in_plane), 1, 0.008)
            << membrane << thin << in_plane;
}

// Sides oblique to the rulings are curved, and their chords should not stretch.
TEST(TwistedBeam, ObliqueSidesLockTheThinOne) {
  const auto thin = [](const char* membrane, const char* levels) {
    return tip("twisted_beam_zigzag.obj", true, membrane, levels);
  };
  EXPECT_GT(tip("twisted_beam_zigzag.obj", false, "displacement", "1"), 0.99);
  EXPECT_LT(thin("displacement", "1"), 0.5);
  EXPECT_GT(thin("assumed", "1"), 0.75);
  EXPECT_NEAR(thin("assumed", "2"), 1, 0.02);
  EXPECT_NEAR(thin("assumed", "3"), 1, 0.003);
}

}  // namespace
}  // namespace limes
