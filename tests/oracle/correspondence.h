#pragma once

#include <string>
#include <vector>

#include "limes/mesh/topology.h"
#include "oracle/osd.h"

namespace limes::oracle {

/// Which of our vertices and faces are which of OpenSubdiv's on one level of refinement, found by
/// following children from the common control mesh. Never by position.
struct Correspondence {
  std::vector<int> vertex;  ///< ours, for each of theirs
  std::vector<int> face;
  std::vector<int> turn;  ///< their corner i is our corner (i + turn) mod size
};

/// The control mesh itself.
Correspondence identity(const Topology& topology);

/// One level down. Our children are named by the numbering that DESIGN promises, restated here:
/// old vertices, edge vertices by first appearance of the edge in (face, corner) order, face
/// vertices; child i of a face is (v_i, e_i, f, e_{i-1}) and the children of a face follow each
/// other. With triangles child i is (v_i, e_i, e_{i-1}), and a fourth is (e_0, e_1, e_2). Says in `wrong` where our child topology is not that, or not OpenSubdiv's.
Correspondence descend(const Correspondence& parent, const osd::Far::TopologyLevel& their_parent,
                       const osd::Far::TopologyLevel& their_child, const Topology& our_parent,
                       const Topology& our_child, std::string& wrong);

}  // namespace limes::oracle
