#include <benchmark/benchmark.h>

#include "limes/limit/limit_surface.h"
#include "limes/mesh/shapes.h"
#include "limes/subdiv/schemes.h"

namespace {

using namespace limes;

void limit_set_up(benchmark::State& state) {
  const auto valence = static_cast<int>(state.range(0));
  const Mesh mesh = shapes::disk(valence, 8);
  for (auto _ : state) {
    const LimitBasis basis(mesh.topology, {}, find_scheme("catmull-clark"));
    benchmark::DoNotOptimize(basis.kinds().size());
  }
  state.SetItemsProcessed(state.iterations() * mesh.topology.num_faces());
}

/// Basis functions in the face at the middle vertex of a disk, `depth` halvings away from it.
void limit_basis_functions(benchmark::State& state) {
  const auto valence = static_cast<int>(state.range(0));
  const auto order = static_cast<int>(state.range(1));
  const auto depth = static_cast<int>(state.range(2));
  const Mesh mesh = shapes::disk(valence, 4);
  const LimitBasis basis(mesh.topology, {}, find_scheme("catmull-clark"));
  const Vec2 uv = std::ldexp(1.0, -depth) * Vec2(0.7, 0.6);
  BasisAt at;
  for (auto _ : state) {
    basis.evaluate(FaceId(0), 0, uv, order, at);
    benchmark::DoNotOptimize(at.N.data());
  }
  state.SetItemsProcessed(state.iterations());
}

void limit_point(benchmark::State& state) {
  const Mesh mesh = shapes::disk(static_cast<int>(state.range(0)), 4);
  const LimitBasis basis(mesh.topology, {}, find_scheme("catmull-clark"));
  const LimitSurface surface(basis, mesh.points.span());
  for (auto _ : state)
    benchmark::DoNotOptimize(surface.evaluate(FaceId(0), 0, {0.3, 0.2}));
  state.SetItemsProcessed(state.iterations());
}

BENCHMARK(limit_set_up)->Arg(4)->Arg(5)->Arg(32);
BENCHMARK(limit_basis_functions)
    ->ArgNames({"valence", "order", "depth"})
    ->ArgsProduct({{4, 5, 32}, {0, 1, 2}, {0, 6}});
BENCHMARK(limit_point)->Arg(4)->Arg(5);

}  // namespace
