#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "limes/report/figure_grid.h"

/// What the gallery shows (docs/gallery.md).
namespace gallery {

struct Settings {
  std::filesystem::path models;  ///< folder of the control meshes, data/gallery
  int most_faces = 16000;        ///< of a refined mesh
  double density = 1.2;          ///< pixels per unit

  /// Steps to draw, of those that a figure of a paper has.
  [[nodiscard]] int steps(int wanted) const { return most_faces < 2000 ? wanted / 2 : wanted; }
};

struct Picture {
  std::string name;  ///< of the file, without extension
  limes::FigureGrid grid;
};

/// Every scheme on one model each.
[[nodiscard]] std::vector<Picture> scheme_pictures(const Settings& settings);
/// Figures 5 to 11 of [velho_quasi48].
[[nodiscard]] std::vector<Picture> velho_pictures(const Settings& settings);
/// Figures 5 and 14 of [kobbelt_1996].
[[nodiscard]] std::vector<Picture> kobbelt_pictures(const Settings& settings);
/// Local refinement with its closures.
[[nodiscard]] std::vector<Picture> adaptive_pictures(const Settings& settings);

}  // namespace gallery
