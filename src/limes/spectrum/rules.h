#pragma once

#include <string>
#include <vector>

#include "limes/spectrum/spectrum.h"
#include "limes/subdiv/explicit_split.h"

namespace limes {

/// An old or new vertex and a weight. On a lattice it is at a point; around an extraordinary vertex or
/// face it has a place in a star; of a single face it is corner number `place.sector`.
struct RuleWeight {
  Vec2 at = Vec2::Zero();
  StarPlace place = {0, 0, 0};
  double weight = 0;
};

/// The weights that make one new vertex.
struct Rule {
  enum class Place {
    regular,
    star,
    face,
    boundary,
    corner,
    crease,
    dart,
    semi_sharp,   ///< crease of sharpness 1/2, smooth after the step
    sharp_vertex  ///< inside, no sharp edges
  };
  Place place;
  ChildVertex::Kind kind;     ///< what the new vertex is made from
  std::vector<int> steps;     ///< from 1; those of the first few in which it occurs
  std::vector<Vec2> element;  ///< on a lattice: the vertices of the face or edge, or the vertex
  std::vector<RuleWeight> weights;

  [[nodiscard]] bool on_lattice() const { return place != Place::star && place != Place::face; }
};

/// What one old vertex contributes to the new ones on a regular mesh: the coefficients of the scheme's
/// symbol. `at` is where a new vertex is, seen from the old one, in edges of the old mesh.
struct RegularMask {
  std::vector<int> steps;
  std::vector<RuleWeight> weights;
};

/// The rules of a scheme as weights, from the scheme's own code on small meshes.
struct SchemeRules {
  std::vector<Rule> rules;  ///< those that differ, by place
  std::vector<RegularMask> masks;
};

/// Steps until the rules of a scheme repeat.
[[nodiscard]] int num_different_steps(const Scheme& scheme);
/// The valence at which it is regular; corners of the face for dual schemes.
[[nodiscard]] int regular_valence(const Scheme& scheme);

/// @param local  the star of another valence, whose rules are listed too; or null
[[nodiscard]] SchemeRules scheme_rules(const Scheme& scheme, double tension,
                                       const LocalSubdivision* local);

}  // namespace limes
