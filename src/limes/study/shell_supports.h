#pragma once

#include <string>
#include <vector>

#include "limes/space/constraints.h"
#include "limes/study/shell_model.h"

namespace limes {

/// Conditions of supports, each a row over the unknowns of a shell.
struct ShellConstraints {
  struct Source {
    std::string where;  ///< of the support
    int first, last;    ///< its rows
  };
  std::vector<ConstraintRow> rows;
  std::vector<Source> sources;
};

/// What the problem's supports hold.
///
/// A list `fix` holds components at the selected nodes. The kinds act on selected boundary edges, at
/// their ends, with the director V there and the edge's direction tau (the mean of two selected edges
/// that turn by less than 30 degrees): `clamped` displacement and rotation; `supported` the
/// displacement; `diaphragm` the displacement along V and tau; `symmetry` the displacement and the
/// director's turn along V x tau, and what turns about V. `hard` holds, besides, the director's turn
/// along tau.
/// @throws InputError for a selection without vertices, or without boundary edges where they are meant
[[nodiscard]] ShellConstraints shell_support_constraints(const ShellModel& model);

/// Directions in space along which supports hold the displacement and the rotation of a side.
struct HeldDirections {
  std::vector<Vec3> displacement, rotation;
};
/// What the same supports hold along every side whose ends they hold, with the mean of the directors at its
/// ends and the direction of its chord.
/// @throws InputError as shell_support_constraints()
[[nodiscard]] IdArray<HalfedgeId, HeldDirections> held_along_sides(const ShellModel& model);

/// One remark per support by symmetry whose edges lie in a plane, not on a line, that a director leaves by
/// more than 5 degrees: five unknowns cannot bend about such edges.
/// @throws InputError as shell_support_constraints()
[[nodiscard]] std::vector<std::string> remarks_on_symmetry(const ShellModel& model);

/// theta . V = 0 at smooth nodes: five unknowns remain. None at hanging nodes, see hanging_transfer().
[[nodiscard]] std::vector<ConstraintRow> drilling_constraints(const ShellModel& model);

/// @throws InputError naming a piece of the mesh and a motion that the supports leave free
void require_no_rigid_motion(const ShellModel& model, const ShellConstraints& supports);

}  // namespace limes
