#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace limes::test {

/// The arrays of a VTU file with appended zlib data, by name; integers as doubles.
using VtuArrays = std::map<std::string, std::vector<double>>;
VtuArrays read_vtu_arrays(const std::string& path);

}  // namespace limes::test
