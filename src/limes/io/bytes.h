#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>

namespace limes {

/// A number from the first sizeof(T) bytes at `bytes`, stored in the given order.
template <class T>
[[nodiscard]] T load_number(const char* bytes, std::endian order = std::endian::little) {
  std::array<char, sizeof(T)> raw;
  std::copy_n(bytes, sizeof(T), raw.begin());
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  T value;
  std::memcpy(&value, raw.data(), sizeof(T));
  return value;
}

/// The bytes of a number, little endian.
template <class T>
[[nodiscard]] std::array<char, sizeof(T)> number_bytes(T value) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), &value, sizeof(T));
  if constexpr (std::endian::native != std::endian::little) std::reverse(raw.begin(), raw.end());
  return raw;
}

}  // namespace limes
