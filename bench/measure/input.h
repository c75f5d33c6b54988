#pragma once

#include <string>

#include "limes/mesh/mesh.h"
#include "limes/subdiv/features.h"
#include "limes/subdiv/scheme.h"
#include "locations.h"
#include "measure.h"

namespace bench {

/// Reads a file as limes does, or makes "shape:NAME" as the programs for other libraries do.
[[nodiscard]] limes::Mesh load_mesh(const std::string& in);

/// The part of a path that names a model: "rook" of "models/rook.obj".
[[nodiscard]] std::string model_name(const std::string& in);

/// A mesh's tags with its own boundary rule, or with boundary edges as creases.
[[nodiscard]] limes::Features features_of(const limes::Mesh& mesh);
[[nodiscard]] limes::Features features_of(const limes::Mesh& mesh,
                                          const limes::Adjacency& adjacency);

/// Sets the number of threads until the program ends.
void use_threads(int threads);

/// Mean of x + 2 y + 3 z, see Centroid.
[[nodiscard]] double checksum(std::span<const limes::Vec3> points);

/// Median of the values; NaN of none.
[[nodiscard]] double median(std::vector<double> values);

/// Fields that every measurement of limes has.
JsonLine first_fields(const Args& args, const std::string& method, const std::string& in,
                      const limes::Scheme& scheme);

}  // namespace bench
