#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace limes {

/// A field over one kind of mesh element: an array that is indexed by that element's id only.
template <class IdType, class T>
class IdArray {
 public:
  IdArray() = default;
  explicit IdArray(std::size_t size) : data_(size) {}
  IdArray(std::size_t size, const T& value) : data_(size, value) {}
  explicit IdArray(std::vector<T> data) : data_(std::move(data)) {}

  [[nodiscard]] T& operator[](IdType id) { return data_[static_cast<std::size_t>(id.value)]; }
  [[nodiscard]] const T& operator[](IdType id) const {
    return data_[static_cast<std::size_t>(id.value)];
  }

  [[nodiscard]] int size() const { return static_cast<int>(data_.size()); }
  [[nodiscard]] bool empty() const { return data_.empty(); }
  void push_back(T value) { data_.push_back(std::move(value)); }
  void reserve(std::size_t size) { data_.reserve(size); }
  void resize(std::size_t size) { data_.resize(size); }
  void resize(std::size_t size, const T& value) { data_.resize(size, value); }

  auto begin() { return data_.begin(); }
  auto end() { return data_.end(); }
  auto begin() const { return data_.begin(); }
  auto end() const { return data_.end(); }

  [[nodiscard]] std::span<const T> span() const { return data_; }
  [[nodiscard]] std::span<T> span() { return data_; }
  [[nodiscard]] const std::vector<T>& vector() const { return data_; }
  [[nodiscard]] std::vector<T>& vector() { return data_; }

  friend bool operator==(const IdArray&, const IdArray&) = default;

 private:
  std::vector<T> data_;
};

}  // namespace limes
