// Limit-surface evaluators built on OpenSubdiv.
#pragma once

#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/bfr/surface.h>
#include <opensubdiv/far/patchMap.h>
#include <opensubdiv/far/patchTableFactory.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/ptexIndices.h>

#include <algorithm>

#include "osd_common.h"

namespace bench {

// Position and derivatives: P, Du, Dv, Duu, Duv, Dvv.
template <typename Real>
struct Sample {
  Real d[6][3];
};

// Adaptive refinement + Far::PatchTable + Far::PatchMap.  Locations are ptex faces.
template <typename Real>
class PatchSurfaces {
 public:
  PatchSurfaces(const Mesh& mesh, const std::string& scheme, int level)
      : refiner_(make_refiner(mesh, scheme)) {
    using namespace osd::Far;
    PatchTableFactory::Options options(unsigned(level & 0xf));
    options.SetPatchPrecision<Real>();
    options.useInfSharpPatch = true;
    options.generateLegacySharpCornerPatches = false;
    options.generateVaryingTables = false;
    options.SetEndCapType(PatchTableFactory::Options::ENDCAP_GREGORY_BASIS);
    refiner_->RefineAdaptive(options.GetRefineAdaptiveOptions());
    table_.reset(PatchTableFactory::Create(*refiner_, options));
    map_ = std::make_unique<PatchMap>(*table_);
    num_ptex_ = PtexIndices(*refiner_).GetNumFaces();
    update(mesh);
  }

  // Recompute refined and local points from the mesh's positions.
  void update(const Mesh& mesh) {
    const std::size_t refined = std::size_t(refiner_->GetNumVerticesTotal());
    points_.resize(refined + std::size_t(table_->GetNumLocalPoints()));
    auto coarse = control_points<Real>(mesh);
    std::copy(coarse.begin(), coarse.end(), points_.begin());
    osd::Far::PrimvarRefinerReal<Real> primvar(*refiner_);
    Values<Real, 3>* source = points_.data();
    for (int level = 1; level <= refiner_->GetMaxLevel(); ++level) {
      auto* target = source + refiner_->GetLevel(level - 1).GetNumVertices();
      primvar.Interpolate(level, source, target);
      source = target;
    }
    if (table_->GetNumLocalPoints())
      table_->GetLocalPointStencilTable<Real>()->UpdateValues(points_.data(),
                                                              points_.data() + refined);
  }

  int num_faces() const { return num_ptex_; }
  int num_patches() const { return table_->GetNumPatchesTotal(); }
  const osd::Far::PatchTable& table() const { return *table_; }
  const osd::Far::PatchMap& map() const { return *map_; }
  const std::vector<Values<Real, 3>>& points() const { return points_; }

  // derivatives: 0 position only, 1 first, 2 second.  false if there is no patch.
  bool evaluate(int face, Real u, Real v, int derivatives, Sample<Real>& out) const {
    const auto* handle = map_->FindPatch(face, double(u), double(v));
    if (!handle) return false;
    Real w[6][32];
    if (derivatives == 0)
      table_->EvaluateBasis(*handle, u, v, w[0]);
    else if (derivatives == 1)
      table_->EvaluateBasis(*handle, u, v, w[0], w[1], w[2]);
    else
      table_->EvaluateBasis(*handle, u, v, w[0], w[1], w[2], w[3], w[4], w[5]);
    const auto cvs = table_->GetPatchVertices(*handle);
    const int n = derivatives == 0 ? 1 : derivatives == 1 ? 3 : 6;
    for (int k = 0; k < n; ++k) {
      Real x = 0, y = 0, z = 0;
      for (int i = 0; i < cvs.size(); ++i) {
        const Real* p = points_[std::size_t(cvs[i])].x;
        x += w[k][i] * p[0];
        y += w[k][i] * p[1];
        z += w[k][i] * p[2];
      }
      out.d[k][0] = x;
      out.d[k][1] = y;
      out.d[k][2] = z;
    }
    return true;
  }

 private:
  std::unique_ptr<osd::Far::TopologyRefiner> refiner_;
  std::unique_ptr<osd::Far::PatchTable> table_;
  std::unique_ptr<osd::Far::PatchMap> map_;
  std::vector<Values<Real, 3>> points_;
  int num_ptex_ = 0;
};

// Bfr: one Surface and its patch points per base face.  Locations are base faces.
template <typename Real>
class BfrSurfaces {
 public:
  using Surface = osd::Bfr::Surface<Real>;
  using Factory = osd::Bfr::RefinerSurfaceFactory<>;

  BfrSurfaces(const Mesh& mesh, const std::string& scheme, int level_smooth, int level_sharp)
      : refiner_(make_refiner(mesh, scheme)) {
    typename Factory::Options options;
    if (level_smooth > 0) options.SetApproxLevelSmooth(level_smooth);
    if (level_sharp > 0) options.SetApproxLevelSharp(level_sharp);
    factory_ = std::make_unique<Factory>(*refiner_, options);
    mesh_points_.assign(mesh.points.begin(), mesh.points.end());
    surfaces_.resize(std::size_t(mesh.num_faces()));
    starts_.resize(surfaces_.size());
    const typename Surface::PointDescriptor desc(3);
    for (std::size_t f = 0; f < surfaces_.size(); ++f) {
      if (!factory_->InitVertexSurface(int(f), &surfaces_[f])) continue;
      starts_[f] = patch_points_.size();
      patch_points_.resize(starts_[f] + 3 * std::size_t(surfaces_[f].GetNumPatchPoints()));
      surfaces_[f].PreparePatchPoints(mesh_points_.data(), desc, patch_points_.data() + starts_[f],
                                      desc);
    }
  }

  int num_faces() const { return int(surfaces_.size()); }
  const Surface& surface(int face) const { return surfaces_[std::size_t(face)]; }

  bool evaluate(int face, Real u, Real v, int derivatives, Sample<Real>& out) const {
    const Surface& s = surfaces_[std::size_t(face)];
    if (!s.IsValid()) return false;
    const typename Surface::PointDescriptor desc(3);
    const Real* points = patch_points_.data() + starts_[std::size_t(face)];
    const Real uv[2] = {u, v};
    if (derivatives == 0)
      s.Evaluate(uv, points, desc, out.d[0]);
    else if (derivatives == 1)
      s.Evaluate(uv, points, desc, out.d[0], out.d[1], out.d[2]);
    else
      s.Evaluate(uv, points, desc, out.d[0], out.d[1], out.d[2], out.d[3], out.d[4], out.d[5]);
    return true;
  }

 private:
  std::unique_ptr<osd::Far::TopologyRefiner> refiner_;
  std::unique_ptr<Factory> factory_;
  std::vector<Real> mesh_points_, patch_points_;
  std::vector<std::size_t> starts_;
  std::vector<Surface> surfaces_;
};

}  // namespace bench
