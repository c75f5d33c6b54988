#pragma once

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "limes/io/bytes.h"
#include "limes/io/io.h"

namespace limes {

/// Gathers small pieces into large ones on their way to a sink. Numbers print independently of
/// the locale, doubles in their shortest exact form.
class ChunkWriter {
 public:
  explicit ChunkWriter(const ByteSink& sink) : sink_(sink) {}

  template <class... Args>
  void print(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<Args>(args)...);
    if (buffer_.size() > chunk_size) flush();
  }
  /// A number as little-endian bytes.
  template <class T>
  void number(T value) {
    const auto bytes = number_bytes(value);
    buffer_.append(bytes.data(), bytes.data() + bytes.size());
    if (buffer_.size() > chunk_size) flush();
  }
  /// Hands over what is left; to be called at the end.
  void flush() {
    sink_({buffer_.data(), buffer_.size()});
    buffer_.clear();
  }

 private:
  static constexpr std::size_t chunk_size = 1 << 16;
  const ByteSink& sink_;
  fmt::memory_buffer buffer_;
};

}  // namespace limes
