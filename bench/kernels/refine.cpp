#include <benchmark/benchmark.h>

#include "limes/mesh/shapes.h"
#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/schemes.h"
#include "limes/subdiv/uniform.h"

namespace {

using namespace limes;

void refinement_adjacency(benchmark::State& state) {
  const auto size = static_cast<int>(state.range(0));
  const Mesh mesh = shapes::torus(size, size);
  for (auto _ : state) {
    const Adjacency adjacency(mesh.topology, Adjacency::Check::edges);
    benchmark::DoNotOptimize(adjacency.num_edges());
  }
  state.SetItemsProcessed(state.iterations() * mesh.topology.num_faces());
}

void refinement_child_topology(benchmark::State& state) {
  const auto size = static_cast<int>(state.range(0));
  const Mesh mesh = shapes::torus(size, size);
  const Adjacency adjacency(mesh.topology);
  const Features features;
  const RefinementStep step(adjacency, features, find_scheme("catmull-clark"));
  for (auto _ : state)
    benchmark::DoNotOptimize(step.child_topology());
  state.SetItemsProcessed(state.iterations() * 4 * mesh.topology.num_faces());
}

void refinement_positions(benchmark::State& state) {
  const auto size = static_cast<int>(state.range(0));
  const Mesh mesh = shapes::torus(size, size);
  const Adjacency adjacency(mesh.topology);
  const Features features;
  const RefinementStep step(adjacency, features, find_scheme("catmull-clark"));
  std::vector<Vec3> fine(static_cast<std::size_t>(step.num_child_vertices()));
  for (auto _ : state) {
    step.apply(mesh.points.span(), fine);
    benchmark::DoNotOptimize(fine.data());
  }
  state.SetItemsProcessed(state.iterations() * step.num_child_vertices());
}

void refinement_matrix(benchmark::State& state) {
  const auto size = static_cast<int>(state.range(0));
  const Mesh mesh = shapes::torus(size, size);
  const Adjacency adjacency(mesh.topology);
  const Features features;
  const RefinementStep step(adjacency, features, find_scheme("catmull-clark"));
  for (auto _ : state)
    benchmark::DoNotOptimize(step.matrix());
  state.SetItemsProcessed(state.iterations() * step.num_child_vertices());
}

void uniform_set_up(benchmark::State& state) {
  const Mesh mesh = shapes::torus(64, 32);
  const Adjacency adjacency(mesh.topology);
  for (auto _ : state) {
    const UniformRefinement refinement(adjacency, {}, find_scheme("catmull-clark"), 5);
    benchmark::DoNotOptimize(refinement.num_vertices());
  }
  state.SetItemsProcessed(state.iterations() * mesh.topology.num_faces());
}

void uniform_positions(benchmark::State& state) {
  const auto depth = static_cast<int>(state.range(0));
  const Mesh mesh = shapes::torus(64, 32);
  const Adjacency adjacency(mesh.topology);
  UniformRefinement refinement(adjacency, {}, find_scheme("catmull-clark"), depth);
  std::vector<Vec3> fine(static_cast<std::size_t>(refinement.num_vertices()));
  for (auto _ : state) {
    refinement.positions(mesh.points.span(), fine);
    benchmark::DoNotOptimize(fine.data());
  }
  state.SetItemsProcessed(state.iterations() * refinement.num_vertices());
}

void uniform_corners(benchmark::State& state) {
  const auto depth = static_cast<int>(state.range(0));
  const Mesh mesh = shapes::torus(64, 32);
  const Adjacency adjacency(mesh.topology);
  const UniformRefinement refinement(adjacency, {}, find_scheme("catmull-clark"), depth);
  std::vector<VertexId> corners(4 * static_cast<std::size_t>(refinement.num_faces()));
  for (auto _ : state) {
    refinement.corners(corners);
    benchmark::DoNotOptimize(corners.data());
  }
  state.SetItemsProcessed(state.iterations() * refinement.num_faces());
}

BENCHMARK(uniform_set_up);
BENCHMARK(uniform_positions)->DenseRange(2, 5);
BENCHMARK(uniform_corners)->DenseRange(2, 5);
BENCHMARK(refinement_adjacency)->Arg(32)->Arg(256);
BENCHMARK(refinement_child_topology)->Arg(32)->Arg(256);
BENCHMARK(refinement_positions)->Arg(32)->Arg(256);
BENCHMARK(refinement_matrix)->Arg(32);

}  // namespace
