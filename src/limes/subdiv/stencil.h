#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "limes/core/ids.h"

namespace limes {

/// The row of weights that makes one new vertex: groups of sources that share a weight.
///
/// A source is an old vertex, or the new vertex of an old face (face_point); a scheme whose face
/// points are weighted means of old vertices may use them to shorten its rules. Within a group the
/// sum is taken over opposite sources first, (p0 + p2) + (p1 + p3), so that for four sources it does
/// not depend on where the walk around a vertex began.
class Stencil {
 public:
  enum class Source : std::uint8_t { vertex, face_point };
  struct Group {
    double weight;
    Source source;
    int begin, end;  ///< range of ids
  };

  void clear() {
    groups_.clear();
    ids_.clear();
  }
  void add(double weight, VertexId v) { add_ids(weight, Source::vertex, {&v.value, 1}); }
  void add(double weight, std::span<const VertexId> vertices) {
    add_ids(weight, Source::vertex, vertices);
  }
  void add(double weight, std::span<const FaceId> faces) {
    add_ids(weight, Source::face_point, faces);
  }
  /// Multiplies all weights, to blend two rules.
  void scale(double factor) {
    for (Group& g : groups_)
      g.weight *= factor;
  }

  [[nodiscard]] std::span<const Group> groups() const { return groups_; }
  /// Of all groups.
  [[nodiscard]] std::span<const std::int32_t> ids() const { return ids_; }
  [[nodiscard]] std::span<const std::int32_t> ids(const Group& g) const {
    return std::span(ids_).subspan(static_cast<std::size_t>(g.begin),
                                   static_cast<std::size_t>(g.end - g.begin));
  }

 private:
  template <class IdSpan>
  void add_ids(double weight, Source source, IdSpan ids) {
    const int begin = static_cast<int>(ids_.size());
    for (const auto& id : ids)
      ids_.push_back(raw(id));
    groups_.push_back({weight, source, begin, static_cast<int>(ids_.size())});
  }
  void add_ids(double weight, Source source, std::span<const std::int32_t> ids) {
    const int begin = static_cast<int>(ids_.size());
    ids_.insert(ids_.end(), ids.begin(), ids.end());
    groups_.push_back({weight, source, begin, static_cast<int>(ids_.size())});
  }
  template <class Tag>
  static std::int32_t raw(Id<Tag> id) {
    return id.value;
  }

  std::vector<Group> groups_;
  std::vector<std::int32_t> ids_;
};

/// Sum of value(ids[k]) over a group, opposite sources first. Value needs + and a copy.
template <class ValueOf>
auto sum_group(std::span<const std::int32_t> ids, const ValueOf& value) {
  const std::size_t n = ids.size();
  if (n % 2 == 1) {
    std::decay_t<decltype(value(ids[0]))> sum = value(ids[0]);
    for (std::size_t k = 1; k < n; ++k)
      sum = sum + value(ids[k]);
    return sum;
  }
  const std::size_t half = n / 2;
  std::decay_t<decltype(value(ids[0]))> sum = value(ids[0]) + value(ids[half]);
  for (std::size_t k = 1; k < half; ++k)
    sum = sum + (value(ids[k]) + value(ids[k + half]));
  return sum;
}

/// Value of a stencil: vertices and face_points are functions from the raw id to the value.
/// Precondition: the stencil has a group.
template <class Value, class VertexValue, class FaceValue>
Value apply_stencil(const Stencil& stencil, const VertexValue& vertices,
                    const FaceValue& face_points) {
  const auto term = [&](const Stencil::Group& g) -> Value {
    const auto ids = stencil.ids(g);
    if (g.source == Stencil::Source::vertex) return g.weight * sum_group(ids, vertices);
    return g.weight * sum_group(ids, face_points);
  };
  Value result = term(stencil.groups()[0]);
  for (const Stencil::Group& g : stencil.groups().subspan(1))
    result = result + term(g);
  return result;
}

}  // namespace limes
