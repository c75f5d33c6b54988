#pragma once

#include "limes/report/figure.h"

namespace limes {

/// Several figures as one drawing, to be compared. Titles, bars and captions stay with their
/// figures; the legends become one, below all of them.
struct FigureGrid {
  std::vector<Figure> figures = {};  ///< row by row; the last row may be shorter
  int columns = 2;                   ///< at least 1
  std::string title = {};            ///< above all; may be empty
};

/// Columns are as wide as their widest figure, rows as high as their highest one.
/// @throws InputError for a grid without figures or columns
[[nodiscard]] Drawing drawing(FigureGrid grid);

}  // namespace limes
