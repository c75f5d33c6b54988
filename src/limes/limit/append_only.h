#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <memory>

namespace limes {

/// An array that only grows and whose elements stay where they are: one thread may append while
/// others read elements that they have been told of. Blocks of 64, 64, 128, 256, ... elements.
template <class T>
class AppendOnly {
 public:
  [[nodiscard]] std::size_t size() const { return size_; }

  T& append() {
    const Place place = place_of(size_);
    if (!blocks_[place.block]) blocks_[place.block] = std::make_unique<T[]>(capacity(place.block));
    ++size_;
    return blocks_[place.block][place.offset];
  }

  [[nodiscard]] T& operator[](std::size_t i) const {
    const Place place = place_of(i);
    return blocks_[place.block][place.offset];
  }

 private:
  static constexpr std::size_t first = 64;
  struct Place {
    std::size_t block, offset;
  };
  static std::size_t capacity(std::size_t block) {
    return block == 0 ? first : first << (block - 1);
  }
  static Place place_of(std::size_t i) {
    const auto block = static_cast<std::size_t>(std::bit_width(i / first));
    return {block, block == 0 ? i : i - capacity(block)};
  }

  std::array<std::unique_ptr<T[]>, 32> blocks_;
  std::size_t size_ = 0;
};

}  // namespace limes
