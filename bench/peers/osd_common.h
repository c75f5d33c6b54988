// OpenSubdiv helpers: a Far::TopologyRefiner from a bench::Mesh, and point types.
#pragma once

#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefiner.h>
#include <opensubdiv/version.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "mesh_io.h"

namespace bench {

namespace osd = OpenSubdiv;

inline std::string osd_version() {
  return std::to_string(OPENSUBDIV_VERSION_MAJOR) + "." + std::to_string(OPENSUBDIV_VERSION_MINOR) +
         "." + std::to_string(OPENSUBDIV_VERSION_PATCH);
}

inline osd::Sdc::SchemeType osd_scheme(const std::string& name) {
  if (name == "catmull-clark") return osd::Sdc::SCHEME_CATMARK;
  if (name == "loop") return osd::Sdc::SCHEME_LOOP;
  if (name == "bilinear") return osd::Sdc::SCHEME_BILINEAR;
  throw std::runtime_error("OpenSubdiv has no scheme " + name);
}

inline osd::Sdc::Options osd_options(const Mesh& mesh) {
  using Options = osd::Sdc::Options;
  Options options;
  options.SetVtxBoundaryInterpolation(mesh.boundary == Boundary::none ? Options::VTX_BOUNDARY_NONE
                                      : mesh.boundary == Boundary::edge_only
                                          ? Options::VTX_BOUNDARY_EDGE_ONLY
                                          : Options::VTX_BOUNDARY_EDGE_AND_CORNER);
  if (mesh.face_varying_boundary >= 0)
    options.SetFVarLinearInterpolation(
        Options::FVarLinearInterpolation(mesh.face_varying_boundary));
  options.SetCreasingMethod(mesh.chaikin_creases ? Options::CREASE_CHAIKIN
                                                 : Options::CREASE_UNIFORM);
  options.SetTriangleSubdivision(mesh.smooth_triangles ? Options::TRI_SUB_SMOOTH
                                                       : Options::TRI_SUB_CATMARK);
  return options;
}

// with_uvs adds the mesh's UVs as face-varying channel 0.
inline std::unique_ptr<osd::Far::TopologyRefiner> make_refiner(const Mesh& mesh,
                                                               const std::string& scheme,
                                                               bool with_uvs = false) {
  using Descriptor = osd::Far::TopologyDescriptor;
  using Factory = osd::Far::TopologyRefinerFactory<Descriptor>;

  std::vector<int> crease_vertices, corner_vertices;
  std::vector<float> crease_weights, corner_weights;
  for (const Crease& c : mesh.creases) {
    crease_vertices.insert(crease_vertices.end(), {c.v0, c.v1});
    crease_weights.push_back(c.sharpness < 0 ? 0 : c.sharpness);
  }
  for (const Corner& c : mesh.corners) {
    corner_vertices.push_back(c.vertex);
    corner_weights.push_back(c.sharpness < 0 ? 0 : c.sharpness);
  }

  Descriptor d;
  d.numVertices = mesh.num_vertices();
  d.numFaces = mesh.num_faces();
  d.numVertsPerFace = mesh.face_sizes.data();
  d.vertIndicesPerFace = mesh.face_vertices.data();
  d.numCreases = int(mesh.creases.size());
  d.creaseVertexIndexPairs = crease_vertices.data();
  d.creaseWeights = crease_weights.data();
  d.numCorners = int(mesh.corners.size());
  d.cornerVertexIndices = corner_vertices.data();
  d.cornerWeights = corner_weights.data();
  d.numHoles = int(mesh.holes.size());
  d.holeIndices = mesh.holes.data();

  Descriptor::FVarChannel channel;
  if (with_uvs && !mesh.face_uvs.empty()) {
    channel.numValues = int(mesh.uvs.size() / 2);
    channel.valueIndices = mesh.face_uvs.data();
    d.numFVarChannels = 1;
    d.fvarChannels = &channel;
  }

  Factory::Options options(osd_scheme(scheme), osd_options(mesh));
  std::unique_ptr<osd::Far::TopologyRefiner> refiner(Factory::Create(d, options));
  if (!refiner) throw std::runtime_error("OpenSubdiv rejected " + mesh.name);
  return refiner;
}

// N values interpolated together by a Far::PrimvarRefiner.
template <typename Real, int N>
struct Values {
  Real x[N];
  void Clear(void* = nullptr) {
    for (Real& v : x)
      v = 0;
  }
  template <typename W>
  void AddWithWeight(const Values& source, W weight) {
    for (int i = 0; i < N; ++i)
      x[i] += Real(weight) * source.x[i];
  }
};

template <typename Real>
std::vector<Values<Real, 3>> control_points(const Mesh& mesh) {
  std::vector<Values<Real, 3>> points(std::size_t(mesh.num_vertices()));
  for (std::size_t v = 0; v < points.size(); ++v)
    for (int k = 0; k < 3; ++k)
      points[v].x[k] = Real(mesh.points[3 * v + k]);
  return points;
}

}  // namespace bench
