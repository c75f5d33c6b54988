// Strategies of refinement beside each other, and meshes smoothed on exact surfaces.

#include "limes/study/refinement_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "limes/adapt/smoothing.h"
#include "limes/core/error.h"
#include "limes/mesh/shapes.h"
#include "limes/study/run.h"

namespace limes {
namespace {

using Overrides = std::vector<std::string>;

const std::filesystem::path data(LIMES_DATA_DIR);

ShellModel model_of(const std::string& name, const Overrides& overrides) {
  return read_shell_model(read_problem(data / name, overrides));
}

double on_rim(const Vec3& x) {
  return std::hypot(25 * std::atan2(x.x(), x.z()), x.y()) - 5;
}

// Shapes get better; every vertex stays on the cylinder, those of borders on their borders.
TEST(ExactSmoothing, RoofKeepsItsBorders) {
  const ShellModel plain = model_of("hole_5.toml", {"mesh.levels=2"});
  const ShellModel smooth =
      model_of("hole_5.toml", {"mesh.levels=2", "mesh.smooth_start=30", "mesh.smoothing=30"});
  EXPECT_GT(worst_distortion(*plain.mesh), 2.5);
  EXPECT_LT(worst_distortion(*smooth.mesh), 0.9 * worst_distortion(*plain.mesh));
  ASSERT_EQ(plain.mesh->points.size(), smooth.mesh->points.size());
  int moved = 0;
  for (int v = 0; v < plain.mesh->points.size(); ++v) {
    const Vec3 &a = plain.mesh->points[VertexId(v)], &b = smooth.mesh->points[VertexId(v)];
    moved += (a - b).norm() > 0.1;
    EXPECT_NEAR(std::hypot(b.x(), b.z()), 25, 1e-12);
    if (std::abs(on_rim(a)) < 1e-9) {
      EXPECT_NEAR(on_rim(b), 0, 1e-10) << v;
    }
    if (std::abs(a.x()) < 1e-9) {
      EXPECT_NEAR(b.x(), 0, 1e-10) << v;
    }
    if (std::abs(a.y()) < 1e-9) {
      EXPECT_NEAR(b.y(), 0, 1e-10) << v;
    }
    if (std::abs(a.y() - 25) < 1e-9) {
      EXPECT_NEAR(b.y(), 25, 1e-10) << v;
    }
  }
  EXPECT_GT(moved, 300);
}

// Both parts slide along the ellipse together; the plate stays flat and keeps its outer border.
TEST(ExactSmoothing, SeamStaysTied) {
  const ShellModel model =
      model_of("cylinder_plate_b.toml", {"mesh.levels=2", "mesh.smoothing=30"});
  int tied = 0;
  for (int v = 0; v < model.mesh->points.size(); ++v) {
    const VertexId node = model.node[VertexId(v)];
    tied += node.value != v;
    EXPECT_EQ(model.mesh->points[node], model.mesh->points[VertexId(v)]) << v;
  }
  EXPECT_EQ(tied, 32);
  EXPECT_GT(worst_distortion(*model_of("cylinder_plate_b.toml", {"mesh.levels=2"}).mesh),
            1.25 * worst_distortion(*model.mesh));
}

// A load on half of a plate whose inside is distorted: as much of it, whatever slides.
TEST(ExactSmoothing, SelectionsKeepTheirMeaning) {
  constexpr const char* problem = R"(
[mesh]
file = "plate.obj"
scheme = "linear"
levels = 1
placement = "exact"
[geometry]
kind = "plane"
axis = [0, 0, 1]
[model]
kind = "mitc4"
[material]
young = 1e6
poisson = 0.3
thickness = 0.1
[[support]]
where = "boundary"
kind = "clamped"
[[load]]
where = "x <= 2"
force_per_area = [0, 0, -1]
)";
  Mesh plate = shapes::grid(4, 4);
  plate.points[VertexId(6)] += Vec3(0.3, 0.3, 0);
  plate.points[VertexId(8)] += Vec3(-0.4, 0.2, 0);
  for (const char* sweeps : {"0", "20"}) {
    const Overrides overrides{std::string("mesh.smooth_start=") + sweeps,
                              std::string("mesh.smoothing=") + sweeps};
    const ShellModel model = build_shell_model(parse_problem(problem, "p.toml", overrides), plate);
    EXPECT_NEAR(solve_shell(model).loads.force.z(), -8, 1e-12) << sweeps;
  }
}

// One mesh, whether it is the only one or the first of an adaptive run.
TEST(ExactSmoothing, IsThatOfTheFirstAdaptiveStep) {
  const Overrides smooth{"mesh.levels=0", "mesh.smooth_start=3"};
  Overrides adaptive = smooth;
  adaptive.emplace_back("adapt.max_steps=1");
  const auto energy = [&](const Overrides& overrides) {
    return run_shell_problem(read_problem(data / "hole_5.toml", overrides)).solution.strain_energy;
  };
  EXPECT_DOUBLE_EQ(energy(smooth), energy(adaptive));
}

// Control vertices stay, the others stay on the surface that the scheme makes of them.
TEST(SchemeSmoothing, SlidesOnTheSurfaceOfKobbelt) {
  const ShellModel plain = model_of("hole_5_kobbelt.toml", {"mesh.levels=2"});
  const ShellModel fine = model_of("hole_5_kobbelt.toml", {"mesh.levels=6"});
  const ShellModel smooth = model_of("hole_5_kobbelt.toml", {"mesh.levels=2", "mesh.smoothing=30"});
  int moved = 0;
  for (int v = 0; v < plain.mesh->points.size(); ++v) {
    const Vec3 &a = plain.mesh->points[VertexId(v)], &b = smooth.mesh->points[VertexId(v)];
    if (v < plain.control.topology.num_vertices()) {
      EXPECT_EQ(a, b) << v;
    }
    moved += (a - b).norm() > 0.05;
  }
  EXPECT_GT(moved, 100);
  // Off the tangent planes of the finer mesh by the sag of its faces, a hundredth of that of the mesh's own.
  double worst = 0;
  for (const Vec3& x : smooth.mesh->points) {
    VertexId nearest(0);
    for (int w = 0; w < fine.mesh->points.size(); ++w)
      if ((x - fine.mesh->points[VertexId(w)]).norm() < (x - fine.mesh->points[nearest]).norm())
        nearest = VertexId(w);
    const HalfedgeId h = fine.adjacency->ring_start(nearest);
    const Vec3 y = fine.mesh->points[nearest];
    const Vec3 a = fine.mesh->points[fine.adjacency->to(h)] - y;
    const Vec3 b = fine.mesh->points[fine.adjacency->from(fine.adjacency->prev(h))] - y;
    worst = std::max(worst, std::abs((x - y).dot(a.cross(b).normalized())));
  }
  EXPECT_LT(worst, 6e-4);  // 1.0e-3 if they did not slide
}

double energy_error(const RefinementPoint& p) {
  return std::abs(p.energy / 1401.0685 - 1);
}

// What the paper sees in its Figures 9 and 10, with the limit of the theory: smoothing and adaptivity need
// fewer unknowns; placement by the scheme stays behind, since 4 x 8 faces do not show the cylinder.
TEST(RefinementStudy, RoofWithAHole) {
  RefinementStudy study = read_refinement_study(
      parse_toml(read_toml_text(data / "hole_study.toml"), data / "hole_study.toml"),
      data / "hole_study.toml");
  std::erase_if(study.strategies, [](const RefinementStrategy& s) {
    return s.name == "inte adap" || s.name == "inte smoo" || s.name == "adap smoo";
  });
  for (RefinementStrategy& s : study.strategies) {
    if (!s.levels.empty()) s.levels = {0, 1, 2, 3};
    if (s.levels.empty()) s.overrides.emplace_back("adapt.max_dofs=4000");
  }
  const std::vector<RefinementCurve> curves = run(study);
  ASSERT_EQ(curves.size(), 4U);
  const auto& uniform = curves[0].points;
  const auto& smooth = curves[1].points;
  const auto& adaptive = curves[2].points;
  const auto& scheme = curves[3].points;
  for (std::size_t level = 1; level < 4; ++level) {
    EXPECT_EQ(uniform[level].elements, 32 << (2 * level));
    EXPECT_LT(energy_error(smooth[level]), 0.8 * energy_error(uniform[level]));
    EXPECT_GT(energy_error(scheme[level]), energy_error(uniform[level]));
  }
  EXPECT_LT(energy_error(adaptive.back()), energy_error(uniform[3]));
  EXPECT_LT(adaptive.back().unknowns, uniform[3].unknowns / 3);
  EXPECT_NEAR(uniform[3].displacement / -0.3493695, 1, 0.006);

  const std::vector<ReportFile> files = study_files(study, curves);
  std::vector<std::string> names;
  for (const ReportFile& file : files) {
    names.push_back(file.name);
    EXPECT_FALSE(file.bytes.empty()) << file.name;
  }
  for (const char* name : {"table.csv", "displacement.svg", "energy-error.svg", "report.html",
                           "unif-orig-start.png", "adap-orig-final.png"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
}

TEST(RefinementStudy, NamesWhatIsWrong) {
  const auto expect = [&](const std::string& text, const std::string& message) {
    const std::filesystem::path path = data / "study.toml";
    try {
      (void)run(read_refinement_study(parse_toml(text, path), path));
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
  };
  const std::string head = "[refinement]\nproblem = \"roof.toml\"\nprobe = \"free edge\"\n";
  expect("[refinement]\nproblem = \"roof.toml\"\n", ":1: [refinement] probe is missing");
  expect(head, "[[strategy]] is missing");
  expect(head + "[[strategy]]\nlevels = [1]\n", ":4: [[strategy]] name is missing");
  expect(head + "[[strategy]]\nname = \"a\"\nlevel = [1]\n",
         ":6: there is no key [[strategy]] level; did you mean 'levels'?");
  expect(head + "[[strategy]]\nname = \"a\"\nlevels = [1, 20]\n",
         ":6: [[strategy]] levels must be a list of whole numbers from 0 to 12");
  expect(head + "component = \"w\"\n", ":4: [refinement] component must be");
  expect(
      "[refinement]\nproblem = \"roof.toml\"\nprobe = \"nowhere\"\n[[strategy]]\nname = \"a\"\n"
      "levels = [1]\n",
      "roof.toml has no [[probe]] 'nowhere'");
  expect(head + "reference_energy = 0\n", ":4: [refinement] reference_energy is 0");
  expect(head + "reference_energy = 9007199254740993\n", "[[strategy]] is missing");
  expect(head + "[[strategy]]\nname = \"a b\"\nlevels = [1]\n[[strategy]]\nname = \"a,b\"\n",
         ":7: strategies 'a b' and 'a,b' have the same name for their pictures");
  expect(head + "[[strategy]]\nname = \"a\"\n", ":4: strategy 'a': there are no levels");
  expect(head + "[[strategy]]\nname = \"a\"\nlevels = [1]\nset = [\"mesh.levles=1\"]\n",
         ":4: strategy 'a': --set mesh.levles");
  expect(
      "[refinement]\nproblem = \"l_shape.toml\"\nprobe = \"middle\"\n[[strategy]]\nname = "
      "\"a\"\nlevels = [1]\n",
      "l_shape.toml is no shell; a [refinement] study compares shells");
}

TEST(Smoothing, RefusesWhatItCannotSlideOn) {
  const auto expect = [&](const std::string& name, const Overrides& overrides,
                          const std::string& message) {
    try {
      (void)model_of(name, overrides);
      ADD_FAILURE() << message;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
  };
  expect("hole_5_kobbelt.toml", {"mesh.scheme=catmull-clark", "mesh.smoothing=3"},
         "here is neither");
  expect("hole_5_kobbelt.toml", {"mesh.smoothing=3", "adapt.max_dofs=1000"},
         "[adapt] smooths meshes on exact surfaces only");
  expect("cylinder_plate_b.toml", {"mesh.smooth_start=3"}, "smooth_start takes quads; face 32");
}

}  // namespace
}  // namespace limes
