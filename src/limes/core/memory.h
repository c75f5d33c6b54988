#pragma once

#include <cstddef>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

namespace limes {

/// Asks the system for huge pages behind a range of memory that has not been touched yet: first
/// writes then cost half as much. Does nothing where that is not possible or the range is small.
void prefer_huge_pages(void* begin, std::size_t bytes);

/// Memory for a large result that is written in one go, and may be written again: not initialised,
/// and laid out so that huge pages fit.
template <class T>
class FreshArray {
  static_assert(std::is_trivially_destructible_v<T>);

 public:
  FreshArray() = default;
  explicit FreshArray(std::size_t size)
      : data_(static_cast<T*>(::operator new(size * sizeof(T), alignment))), size_(size) {
    prefer_huge_pages(data_, size * sizeof(T));
  }
  FreshArray(FreshArray&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}
  FreshArray& operator=(FreshArray&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
  }
  ~FreshArray() { ::operator delete(data_, alignment); }

  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] std::span<T> span() { return {data_, size_}; }
  [[nodiscard]] std::span<const T> span() const { return {data_, size_}; }

 private:
  static constexpr std::align_val_t alignment{std::size_t{1} << 21};
  T* data_ = nullptr;
  std::size_t size_ = 0;
};

/// Gives an empty std::vector its size, with huge pages behind it.
template <class Vector>
void resize_fresh(Vector& v, std::size_t size) {
  v.reserve(size);
  prefer_huge_pages(v.data(), size * sizeof(*v.data()));
  v.resize(size);
}

}  // namespace limes
