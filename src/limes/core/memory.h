#pragma once

#include <cstddef>

namespace limes {

/// Asks the system for huge pages behind a range of memory that has not been touched yet: first
/// writes then cost half as much. Does nothing where that is not possible or the range is small.
void prefer_huge_pages(void* begin, std::size_t bytes);

/// Gives an empty std::vector its size, with huge pages behind it.
template <class Vector>
void resize_fresh(Vector& v, std::size_t size) {
  v.reserve(size);
  prefer_huge_pages(v.data(), size * sizeof(*v.data()));
  v.resize(size);
}

}  // namespace limes
