#include "limes/io/ply_header.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>

#include "limes/core/text.h"
#include "limes/io/lines.h"

namespace limes {
namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> type_names{{
    {"char", PlyType::int8},
    {"int8", PlyType::int8},
    {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},
    {"short", PlyType::int16},
    {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},
    {"uint16", PlyType::uint16},
    {"int", PlyType::int32},
    {"int32", PlyType::int32},
    {"uint", PlyType::uint32},
    {"uint32", PlyType::uint32},
    {"float", PlyType::float32},
    {"float32", PlyType::float32},
    {"double", PlyType::float64},
    {"float64", PlyType::float64},
}};

class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, std::string_view file)
      : file_(file), bytes_(bytes), lines_(bytes) {}

  PlyHeader read();

 private:
  void read_line(std::string_view keyword, std::string_view rest);
  PlyEncoding encoding(std::string_view rest) const;
  PlyElement element(std::string_view rest);
  PlyProperty property(std::string_view rest) const;
  PlyType type(std::string_view name) const;
  std::size_t data_begin() const;
  void check_sizes(const PlyHeader& header) const;

  template <class... Args>
  [[nodiscard]] InputError error(fmt::format_string<Args...> format, Args&&... args) const {
    return error_at(file_, lines_.number(), format, std::forward<Args>(args)...);
  }

  std::string_view file_, bytes_;
  LineReader lines_;
  std::optional<PlyEncoding> encoding_;
  std::vector<PlyElement> elements_;
  std::set<std::string> names_;  // of the elements
};

PlyHeader HeaderReader::read() {
  if (!lines_.next() || trim(lines_.line()) != "ply")
    throw error_at(file_, 1, "no PLY file; its first line is 'ply'");
  while (true) {
    if (!lines_.next())
      throw error_at(file_, lines_.number() + 1, "the header ends without 'end_header'");
    std::string_view rest = lines_.line();
    const std::string_view keyword = next_token(rest);
    if (keyword == "end_header") break;
    read_line(keyword, rest);
  }
  if (!encoding_) throw error("the header has no format; 'format ascii 1.0' is right");
  PlyHeader header{*encoding_, std::move(elements_), data_begin(), lines_.number()};
  check_sizes(header);
  return header;
}

void HeaderReader::read_line(std::string_view keyword, std::string_view rest) {
  if (keyword == "format") {
    encoding_ = encoding(rest);
  } else if (keyword == "element") {
    elements_.push_back(element(rest));
  } else if (keyword == "property") {
    if (elements_.empty()) throw error("a property before the first element");
    elements_.back().properties.push_back(property(rest));
  } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
    throw error("{} is no keyword of a PLY header", quote(keyword));
  }
}

PlyEncoding HeaderReader::encoding(std::string_view rest) const {
  const std::string_view name = next_token(rest);
  if (name == "ascii") return PlyEncoding::ascii;
  if (name == "binary_little_endian") return PlyEncoding::binary_little_endian;
  if (name == "binary_big_endian") return PlyEncoding::binary_big_endian;
  throw error("format {} is unknown; ascii, binary_little_endian and binary_big_endian are right",
              quote(name));
}

PlyElement HeaderReader::element(std::string_view rest) {
  const std::string name(next_token(rest));
  const std::string_view token = next_token(rest);
  const auto count = parse_integer(token);
  if (!count || *count < 0)
    throw error("element {}: count {} is wrong; 0 or more is right", quote(name), quote(token));
  if (!names_.insert(name).second) throw error("element {} is declared twice", quote(name));
  return {name, *count, {}};
}

PlyProperty HeaderReader::property(std::string_view rest) const {
  const std::string_view first = next_token(rest);
  PlyProperty result;
  result.is_list = first == "list";
  if (result.is_list) {
    result.count_type = type(next_token(rest));
    if (result.count_type == PlyType::float32 || result.count_type == PlyType::float64)
      throw error("the length of a list is a float; an integer type is right");
  }
  result.type = type(result.is_list ? next_token(rest) : first);
  result.name = next_token(rest);
  if (result.name.empty()) throw error("a property without a name; 'property float x' is right");
  return result;
}

PlyType HeaderReader::type(std::string_view name) const {
  const auto entry = std::find_if(type_names.begin(), type_names.end(),
                                  [&](const auto& known) { return known.first == name; });
  if (entry == type_names.end())
    throw error("type {} is unknown; char to uint, float and double are right", quote(name));
  return entry->second;
}

/// Binary data begin right after the line end of "end_header". Where all lines end in CR, an LF
/// that follows belongs to the data.
std::size_t HeaderReader::data_begin() const {
  const std::size_t end = bytes_.size() - lines_.rest().size();
  const std::size_t first_end = bytes_.find_first_of("\r\n");
  const bool only_cr = bytes_[first_end] == '\r' && bytes_[first_end + 1] != '\n';
  const bool took_lf = end >= 2 && bytes_[end - 1] == '\n' && bytes_[end - 2] == '\r';
  return only_cr && took_lf ? end - 1 : end;
}

/// Every entry takes at least its scalars and the lengths of its lists; in text two bytes each.
void HeaderReader::check_sizes(const PlyHeader& header) const {
  const auto available = static_cast<std::int64_t>(bytes_.size() - header.size) + 1;
  for (const PlyElement& element : header.elements) {
    std::int64_t least = 0;
    for (const PlyProperty& p : element.properties) {
      const std::size_t binary = size_of(p.is_list ? p.count_type : p.type);
      least += header.encoding == PlyEncoding::ascii ? 2 : static_cast<std::int64_t>(binary);
    }
    if (least > 0 && element.count > available / least)
      throw InputError("{}: element {} announces {} entries; the file is too short for them", file_,
                       quote(element.name), element.count);
  }
}

}  // namespace

std::size_t size_of(PlyType type) {
  constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

PlyHeader read_ply_header(std::string_view bytes, std::string_view file) {
  return HeaderReader(bytes, file).read();
}

}  // namespace limes
