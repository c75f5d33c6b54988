#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "limes/curve/polyline.h"

namespace limes {

/// Control polygons as read from the 'l' lines of an OBJ file.
struct CurveFile {
  std::vector<Polyline> curves;
  std::vector<std::string> remarks;
};

/// Reads the polylines of an obj file. One that ends where it began is closed; one that begins with the last
/// vertex of the one before continues it.
/// @throws InputError as read_mesh(), and for a file without polylines
[[nodiscard]] CurveFile read_curves(const std::filesystem::path& file);
[[nodiscard]] CurveFile read_obj_curves(std::string_view text, std::string_view file);

/// Writes an obj file, every point once. @throws as write_mesh()
void write_curves(const std::filesystem::path& file, const std::vector<Polyline>& curves);

}  // namespace limes
