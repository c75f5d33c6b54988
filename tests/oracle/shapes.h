#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "limes/mesh/mesh.h"

namespace limes::oracle {

/// One file of tests/data/opensubdiv with one boundary rule.
struct Case {
  std::string shape;
  BoundaryRule boundary;
};
std::string name_of(const Case& c);
void PrintTo(const Case& c, std::ostream* out);

/// All files whose name starts with a prefix, without extension, sorted.
std::vector<std::string> shapes_with(const std::string& prefix);

/// Why we refuse a shape; empty for all that we take.
std::string refusal_of(const std::string& shape);

/// The shapes that we take, each with all three boundary rules.
std::vector<Case> manifold_cases(const std::string& prefix);

Mesh read_shape(const std::string& shape);

/// Diagonal of the box around the points.
double size_of(const Mesh& mesh);

}  // namespace limes::oracle
