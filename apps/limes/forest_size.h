#pragma once

#include <cstdint>

#include "limes/mesh/topology.h"
#include "limes/subdiv/scheme.h"

namespace limes::app {

/// What refinement in places costs, counted before it is made.
class ForestSize {
 public:
  ForestSize(const Topology& control, const Scheme& scheme, bool bisect, std::int64_t memory_limit);

  /// Refuses a round before any of its splits, as require_feasible() does.
  /// @param round   from 1
  /// @param leaves  before it
  /// @param marked  of them; more are split as these ask for it
  /// @throws InputError saying how many levels are possible
  void require_round(int round, std::int64_t leaves, std::int64_t marked) const;
  /// The same for rounds that split every face.
  void require_all(int rounds) const;

 private:
  void require(int round, std::int64_t leaves) const;

  bool bisect_;
  double bytes_per_leaf_, first_leaves_;
  std::int64_t memory_limit_;
};

}  // namespace limes::app
