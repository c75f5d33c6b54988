#include <gtest/gtest.h>

#include "limes/subdiv/kobbelt_literal.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/schemes.h"
#include "subdiv/interpolatory.h"

// Nets refined by another program: docs/theory/kobbelt.md.

namespace limes {
namespace {

RefineOptions options_of(const nlohmann::json& golden, int levels) {
  RefineOptions options{.levels = levels};
  options.corners = CornerRule::none;  // the file lists the breakpoints
  options.tension = 16.0 * golden.at("omega").get<double>();
  return options;
}

double distance(const Mesh& a, const Mesh& b) {
  double most = 0;
  for (int v = 0; v < a.points.size(); ++v)
    most = std::max(most, (a.points[VertexId(v)] - b.points[VertexId(v)]).cwiseAbs().maxCoeff());
  return most;
}

class GoldenNet : public testing::TestWithParam<std::string> {};

TEST_P(GoldenNet, IsReproduced) {
  const nlohmann::json golden = read_interpolatory(GetParam());
  const Mesh control = control_net(golden);
  const auto& levels = golden.at("levels");
  ASSERT_FALSE(levels.empty());
  for (int level = 1; level <= static_cast<int>(levels.size()); ++level) {
    SCOPED_TRACE(level);
    const Mesh expected = net_of(levels[static_cast<std::size_t>(level) - 1]);
    const Mesh fine = refine(control, find_scheme("kobbelt"), options_of(golden, level));
    ASSERT_EQ(fine.topology, expected.topology);
    EXPECT_LE(distance(fine, expected), 1e-13 * size_of(expected));
  }
}

INSTANTIATE_TEST_SUITE_P(Nets, GoldenNet,
                         testing::Values("cube", "cube_noisy", "cube_noisy_omega_0",
                                         "cube_noisy_omega_1_8", "torus_6x5", "star_3", "star_5",
                                         "star_6", "star_8", "L_all_corners", "L_convex_corners",
                                         "L_smooth", "grid_5x4_corners", "grid_5x4_corners_and_2",
                                         "grid_5x4_smooth", "strip_4x1_corners", "quad_corners",
                                         "quad_smooth", "cylinder_8x2"),
                         [](const auto& name) { return name.param; });

/// The same with the outer edge points themselves in rule (3), through the library.
TEST(GoldenNetLiteral, IsReproduced) {
  const nlohmann::json golden = read_interpolatory("cube_literal");
  Mesh net = control_net(golden);
  for (const auto& level : golden.at("levels")) {
    const Mesh expected = net_of(level);
    net = refine_literally(net, 16.0 * golden.at("omega").get<double>());
    ASSERT_EQ(net.topology, expected.topology);
    EXPECT_LE(distance(net, expected), 1e-13 * size_of(expected));
  }
}

}  // namespace
}  // namespace limes
