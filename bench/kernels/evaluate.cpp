#include <benchmark/benchmark.h>

#include "limes/limit/bulk_evaluator.h"
#include "limes/limit/closest_point.h"
#include "limes/limit/limit_surface.h"
#include "limes/mesh/shapes.h"
#include "limes/subdiv/schemes.h"
#include "stam.h"

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

/// 4,096 points spread over the faces of a disk.
void limit_bulk(benchmark::State& state) {
  const auto order = static_cast<int>(state.range(1));
  const Mesh mesh = shapes::disk(static_cast<int>(state.range(0)), 8);
  const LimitBasis basis(mesh.topology, {}, find_scheme("catmull-clark"));
  const BulkEvaluator bulk(basis, mesh.points.span());
  std::vector<SurfaceLocation> places;
  for (int i = 0; i < 4096; ++i)
    places.push_back({FaceId(7919 * i % mesh.topology.num_faces()), 0,
                      Vec2(i % 64 + 0.5, i / 64 % 64 + 0.5) / 64});
  SurfaceValues values;
  for (auto _ : state) {
    bulk.evaluate(places, order, values);
    benchmark::DoNotOptimize(values.x.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(places.size()));
}

/// Closest points of a torus from a grid of places around and inside it.
void closest(benchmark::State& state) {
  const Mesh mesh = shapes::torus(64, 32);
  const LimitBasis basis(mesh.topology, {}, find_scheme("catmull-clark"));
  const SurfaceTree tree(basis, mesh.points.span());
  std::vector<Vec3> queries;
  for (int i = 0; i < 512; ++i)
    queries.emplace_back(i % 8 - 3.4, i / 8 % 8 - 3.6, 0.5 * (i / 64) - 1.8);
  for (auto _ : state)
    benchmark::DoNotOptimize(closest_points(tree, queries).data());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(queries.size()));
}

/// [stam_1998], the same face as limit_basis_functions.
void stam_point(benchmark::State& state) {
  const Mesh mesh = shapes::disk(static_cast<int>(state.range(0)), 4);
  const Adjacency adjacency(mesh.topology);
  const Features features;
  const Ring ring = gather_ring(adjacency, features, Sharpness(adjacency, features),
                                find_scheme("catmull-clark"), FaceId(0));
  const bench::StamTable table(ring, find_scheme("catmull-clark"));
  const bench::Points projected = table.project(bench::controls_of(ring, mesh.points.span()));
  for (auto _ : state)
    benchmark::DoNotOptimize(table.evaluate(projected, {0.3, 0.2}));
  state.SetItemsProcessed(state.iterations());
}

BENCHMARK(limit_bulk)->ArgNames({"valence", "order"})->ArgsProduct({{4, 5}, {0, 1, 2}});
BENCHMARK(closest);
BENCHMARK(stam_point)->Arg(5)->Arg(32);
BENCHMARK(limit_set_up)->Arg(4)->Arg(5)->Arg(32);
BENCHMARK(limit_basis_functions)
    ->ArgNames({"valence", "order", "depth"})
    ->ArgsProduct({{4, 5, 32}, {0, 1, 2}, {0, 6}});
BENCHMARK(limit_point)->Arg(4)->Arg(5);

}  // namespace
