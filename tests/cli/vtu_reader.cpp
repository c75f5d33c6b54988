#include "cli/vtu_reader.h"

#include <zlib.h>

#include <cstring>
#include <regex>
#include <stdexcept>

#include "cli/program.h"

namespace limes::test {
namespace {

std::uint64_t number_at(const std::string& bytes, std::size_t offset) {
  std::uint64_t value = 0;
  std::memcpy(&value, bytes.data() + offset, sizeof(value));
  return value;
}

/// Blocks of VTK's vtkZLibDataCompressor with UInt64 headers.
std::string decompress(const std::string& bytes, std::size_t offset) {
  const std::uint64_t num_blocks = number_at(bytes, offset);
  const std::uint64_t block_size = number_at(bytes, offset + 8);
  std::size_t data = offset + 24 + 8 * num_blocks;
  std::string result;
  for (std::uint64_t b = 0; b < num_blocks; ++b) {
    const std::uint64_t compressed = number_at(bytes, offset + 24 + 8 * b);
    std::string block(block_size, '\0');
    uLongf size = block_size;
    if (uncompress(reinterpret_cast<Bytef*>(block.data()), &size,
                   reinterpret_cast<const Bytef*>(bytes.data() + data), compressed) != Z_OK)
      throw std::runtime_error("broken zlib block");
    result.append(block, 0, size);
    data += compressed;
  }
  return result;
}

template <class T>
std::vector<double> numbers(const std::string& bytes) {
  std::vector<double> values(bytes.size() / sizeof(T));
  for (std::size_t i = 0; i < values.size(); ++i) {
    T value;
    std::memcpy(&value, bytes.data() + i * sizeof(T), sizeof(T));
    values[i] = static_cast<double>(value);
  }
  return values;
}

}  // namespace

VtuArrays read_vtu_arrays(const std::string& path) {
  const std::string bytes = read_file(path);
  const std::size_t data = bytes.find("<AppendedData encoding=\"raw\">");
  const std::string xml = bytes.substr(0, data);
  const std::size_t first = bytes.find('_', data) + 1;
  const std::regex array("<DataArray type=\"(\\w+)\" Name=\"(\\w+)\"[^>]*offset=\"(\\d+)\"");
  VtuArrays arrays;
  for (std::sregex_iterator it(xml.begin(), xml.end(), array), end; it != end; ++it) {
    const std::string raw = decompress(bytes, first + std::stoull((*it)[3]));
    const std::string type = (*it)[1];
    arrays[(*it)[2]] = type == "Float64" ? numbers<double>(raw)
                       : type == "Int64" ? numbers<std::int64_t>(raw)
                                         : numbers<std::uint8_t>(raw);
  }
  return arrays;
}

}  // namespace limes::test
