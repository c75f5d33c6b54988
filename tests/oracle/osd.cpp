#include "oracle/osd.h"

#include <opensubdiv/far/patchTableFactory.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/ptexIndices.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <algorithm>
#include <stdexcept>

namespace limes::oracle {
namespace {

/// What OpenSubdiv interpolates.
struct Value {
  Vec3 x = Vec3::Zero();
  void Clear(void* = nullptr) { x.setZero(); }
  void AddWithWeight(const Value& source, double weight) { x += weight * source.x; }
};

std::vector<Value> values(std::span<const Vec3> points) {
  std::vector<Value> result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    result[i].x = points[i];
  return result;
}

std::vector<Vec3> positions(const std::vector<Value>& v) {
  std::vector<Vec3> result;
  for (const Value& value : v)
    result.push_back(value.x);
  return result;
}

osd::Sdc::Options sdc_options(const Tags& tags, BoundaryRule boundary) {
  using Options = osd::Sdc::Options;
  Options options;
  options.SetVtxBoundaryInterpolation(boundary == BoundaryRule::none ? Options::VTX_BOUNDARY_NONE
                                      : boundary == BoundaryRule::edges
                                          ? Options::VTX_BOUNDARY_EDGE_ONLY
                                          : Options::VTX_BOUNDARY_EDGE_AND_CORNER);
  options.SetCreasingMethod(tags.crease_method == CreaseMethod::chaikin ? Options::CREASE_CHAIKIN
                                                                        : Options::CREASE_UNIFORM);
  options.SetTriangleSubdivision(tags.smooth_triangles ? Options::TRI_SUB_SMOOTH
                                                       : Options::TRI_SUB_CATMARK);
  return options;
}

}  // namespace

std::unique_ptr<osd::Far::TopologyRefiner> make_refiner(const Mesh& mesh, const Scheme& scheme,
                                                        BoundaryRule boundary) {
  using Descriptor = osd::Far::TopologyDescriptor;
  using Factory = osd::Far::TopologyRefinerFactory<Descriptor>;
  const Topology& topology = mesh.topology;
  std::vector<int> sizes, corners, crease_ends, corner_vertices, holes;
  std::vector<float> crease_sharpness, corner_sharpness;
  for (int f = 0; f < topology.num_faces(); ++f)
    sizes.push_back(topology.face_size(FaceId(f)));
  for (const VertexId v : topology.corners())
    corners.push_back(v.value);
  for (const CreaseTag& t : mesh.tags.creases) {
    crease_ends.insert(crease_ends.end(), {t.a.value, t.b.value});
    crease_sharpness.push_back(t.sharpness);
  }
  for (const CornerTag& t : mesh.tags.corners) {
    corner_vertices.push_back(t.vertex.value);
    corner_sharpness.push_back(t.sharpness);
  }
  for (const FaceId f : mesh.tags.holes)
    holes.push_back(f.value);

  Descriptor d;
  d.numVertices = topology.num_vertices();
  d.numFaces = topology.num_faces();
  d.numVertsPerFace = sizes.data();
  d.vertIndicesPerFace = corners.data();
  d.numCreases = static_cast<int>(crease_sharpness.size());
  d.creaseVertexIndexPairs = crease_ends.data();
  d.creaseWeights = crease_sharpness.data();
  d.numCorners = static_cast<int>(corner_vertices.size());
  d.cornerVertexIndices = corner_vertices.data();
  d.cornerWeights = corner_sharpness.data();
  d.numHoles = static_cast<int>(holes.size());
  d.holeIndices = holes.data();
  const auto type = scheme.name == "linear" ? osd::Sdc::SCHEME_BILINEAR
                    : scheme.name == "loop" ? osd::Sdc::SCHEME_LOOP
                                            : osd::Sdc::SCHEME_CATMARK;
  Factory::Options options(type, sdc_options(mesh.tags, boundary));
  std::unique_ptr<osd::Far::TopologyRefiner> refiner(Factory::Create(d, options));
  if (!refiner) throw std::runtime_error("OpenSubdiv rejected the mesh");
  return refiner;
}

std::vector<std::vector<Vec3>> refine_uniformly(osd::Far::TopologyRefiner& refiner,
                                                const Mesh& mesh, int levels) {
  osd::Far::TopologyRefiner::UniformOptions options(static_cast<unsigned>(levels) & 0xfU);
  options.fullTopologyInLastLevel = true;
  refiner.RefineUniform(options);
  const osd::Far::PrimvarRefinerReal<double> primvar(refiner);
  std::vector<std::vector<Vec3>> result{mesh.points.vector()};
  std::vector<Value> current = values(mesh.points.span());
  for (int level = 1; level <= levels; ++level) {
    std::vector<Value> next(static_cast<std::size_t>(refiner.GetLevel(level).GetNumVertices()));
    primvar.Interpolate(level, current, next);
    current = std::move(next);
    result.push_back(positions(current));
  }
  return result;
}

std::vector<Vec3> limit_of_last_level(const osd::Far::TopologyRefiner& refiner,
                                      const std::vector<Vec3>& last) {
  const osd::Far::PrimvarRefinerReal<double> primvar(refiner);
  std::vector<Value> limit(last.size());
  primvar.Limit(values(last), limit);
  return positions(limit);
}

std::array<std::vector<Vec3>, 2> tangents_of_last_level(const osd::Far::TopologyRefiner& refiner,
                                                        const std::vector<Vec3>& last) {
  const osd::Far::PrimvarRefinerReal<double> primvar(refiner);
  std::vector<Value> limit(last.size()), first(last.size()), second(last.size());
  primvar.Limit(values(last), limit, first, second);
  return {positions(first), positions(second)};
}

bool has_exact_limit(const osd::Far::TopologyLevel& level, int vertex) {
  if (level.IsVertexSemiSharp(vertex)) return false;
  if (level.GetVertexRule(vertex) == osd::Sdc::Crease::RULE_DART) return false;
  const auto edges = level.GetVertexEdges(vertex);
  if (edges.size() == 2 && !level.IsVertexBoundary(vertex)) return false;
  for (int i = 0; i < edges.size(); ++i)
    if (level.IsEdgeSemiSharp(edges[i])) return false;
  return true;
}

LimitPatches::LimitPatches(const Mesh& mesh, const Scheme& scheme, BoundaryRule boundary)
    : refiner_(make_refiner(mesh, scheme, boundary)), topology_(mesh.topology) {
  using Factory = osd::Far::PatchTableFactory;
  Factory::Options options(10);
  options.SetPatchPrecision<double>();
  options.useInfSharpPatch = true;
  options.generateLegacySharpCornerPatches = false;
  options.generateVaryingTables = false;
  options.SetEndCapType(Factory::Options::ENDCAP_GREGORY_BASIS);
  refiner_->RefineAdaptive(options.GetRefineAdaptiveOptions());
  table_.reset(Factory::Create(*refiner_, options));
  map_ = std::make_unique<osd::Far::PatchMap>(*table_);
  const osd::Far::PtexIndices ptex(*refiner_);
  for (int f = 0; f < topology_.num_faces(); ++f)
    first_ptex_.push_back(ptex.GetFaceId(f));

  const auto refined = static_cast<std::size_t>(refiner_->GetNumVerticesTotal());
  std::vector<Value> points(refined + static_cast<std::size_t>(table_->GetNumLocalPoints()));
  const std::vector<Value> control = values(mesh.points.span());
  std::copy(control.begin(), control.end(), points.begin());
  const osd::Far::PrimvarRefinerReal<double> primvar(*refiner_);
  Value* source = points.data();
  for (int level = 1; level <= refiner_->GetMaxLevel(); ++level) {
    Value* target = source + refiner_->GetLevel(level - 1).GetNumVertices();
    primvar.Interpolate(level, source, target);
    source = target;
  }
  if (table_->GetNumLocalPoints() > 0)
    table_->GetLocalPointStencilTable<double>()->UpdateValues(points.data(),
                                                              points.data() + refined);
  points_ = positions(points);
}

LimitPatches::Point LimitPatches::evaluate(FaceId f, int corner, const Vec2& uv) const {
  Point out;
  const int ptex = first_ptex_[static_cast<std::size_t>(f.value)] + corner;
  const auto* handle = map_->FindPatch(ptex, uv.x(), uv.y());
  if (!handle) return out;
  out.exists = true;
  const auto type = table_->GetPatchDescriptor(*handle).GetType();
  out.regular =
      type == osd::Far::PatchDescriptor::REGULAR || type == osd::Far::PatchDescriptor::LOOP;
  std::array<std::array<double, 32>, 6> w{};
  table_->EvaluateBasis(*handle, uv.x(), uv.y(), w[0].data(), w[1].data(), w[2].data(), w[3].data(),
                        w[4].data(), w[5].data());
  const auto vertices = table_->GetPatchVertices(*handle);
  const auto sum = [&](std::size_t k) {
    Vec3 x = Vec3::Zero();
    for (int i = 0; i < vertices.size(); ++i)
      x += w[k][static_cast<std::size_t>(i)] * points_[static_cast<std::size_t>(vertices[i])];
    return x;
  };
  const int whole = refiner_->GetSchemeType() == osd::Sdc::SCHEME_LOOP ? 3 : 4;
  const double scale = topology_.face_size(f) == whole ? 1.0 : 0.5;
  out.x = sum(0);
  out.xu = scale * sum(1);
  out.xv = scale * sum(2);
  const bool upside_down = whole == 3 && table_->GetPatchParam(*handle).IsTriangleRotated();
  const double second = (upside_down ? -1.0 : 1.0) * scale * scale;
  out.xuu = second * sum(3);
  out.xuv = second * sum(4);
  out.xvv = second * sum(5);
  return out;
}

}  // namespace limes::oracle
