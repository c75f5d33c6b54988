#pragma once

#include <array>

namespace limes {

/// Where VTK puts the 16 points (i, j) of a quad of degree 3, from the documentation of
/// vtkHigherOrderQuadrilateral: corners, edges, inside.
constexpr std::array<std::array<int, 2>, 16> cubic_quad_points{{
    {0, 0},
    {3, 0},
    {3, 3},
    {0, 3},  // corners
    {1, 0},
    {2, 0},
    {3, 1},
    {3, 2},
    {1, 3},
    {2, 3},
    {0, 1},
    {0, 2},  // edges
    {1, 1},
    {2, 1},
    {1, 2},
    {2, 2}  // inside
}};

}  // namespace limes
