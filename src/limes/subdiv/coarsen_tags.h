#pragma once

#include <string>

#include "limes/mesh/tags.h"
#include "limes/subdiv/features.h"
#include "limes/subdiv/quadrisection_labels.h"

namespace limes {

/// Sharp edges and vertices of a refined mesh as they were one level up.
struct CoarseTags {
  Tags tags;           ///< creases and corners only
  std::string misfit;  ///< why the labelling cannot be right; empty if it can
  std::string remark;  ///< a sharpness that no coarse sharpness explains; empty: none
};

/// @param fine    adjacency of the refined mesh, with its features and their sharpness
/// @param coarse  of the labelled mesh; `adjacency` belongs to coarse.topology
[[nodiscard]] CoarseTags coarsen_tags(const Adjacency& fine, const Features& features,
                                      const Sharpness& sharpness, const VertexOrigins& origins,
                                      const Unsplit& coarse, const Adjacency& adjacency);

}  // namespace limes
