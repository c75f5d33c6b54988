#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace limes {

/// The scalar types of PLY; both sets of names (char, int8, ...) mean these.
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

[[nodiscard]] std::size_t size_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type;
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  ///< of a list
};

struct PlyElement {
  std::string name;
  std::int64_t count;
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding { ascii, binary_little_endian, binary_big_endian };

struct PlyHeader {
  PlyEncoding encoding;
  std::vector<PlyElement> elements;
  std::size_t size;        ///< bytes up to the data
  std::int64_t num_lines;  ///< lines up to the data
};

/// Everything up to "end_header". LF, CRLF and CR end its lines.
/// @throws InputError, also for counts that the rest of the file cannot hold
[[nodiscard]] PlyHeader read_ply_header(std::string_view bytes, std::string_view file);

}  // namespace limes
