#include "limes/subdiv/crease.h"

#include <algorithm>

namespace limes {

VertexRule vertex_rule(float vertex_sharpness, std::span<const float> edge_sharpness) {
  if (is_sharp(vertex_sharpness)) return VertexRule::corner;
  const auto sharp = std::count_if(edge_sharpness.begin(), edge_sharpness.end(), is_sharp);
  if (sharp > 2) return VertexRule::corner;
  if (sharp == 2) return VertexRule::crease;
  return sharp == 1 ? VertexRule::dart : VertexRule::smooth;
}

float decayed(float sharpness) {
  if (is_infinite(sharpness)) return sharpness;
  return std::max(sharpness - 1.0F, 0.0F);
}

float decayed_at_vertex(CreaseMethod method, std::size_t edge,
                        std::span<const float> edge_sharpness) {
  const float s = edge_sharpness[edge];
  if (method == CreaseMethod::uniform || !is_sharp(s) || is_infinite(s)) return decayed(s);
  // Chaikin: 3/4 of the edge's own sharpness, 1/4 of the mean of the other semi-sharp ones.
  float sum = 0.0F;
  int count = 0;
  for (const float t : edge_sharpness) {
    if (!is_sharp(t) || is_infinite(t)) continue;
    sum += t;
    ++count;
  }
  if (count < 2) return decayed(s);
  const float others = (sum - s) / static_cast<float>(count - 1);
  return std::max(0.75F * s + 0.25F * others - 1.0F, 0.0F);
}

float transition_weight(float vertex_sharpness, float child_vertex_sharpness,
                        std::span<const float> edge_sharpness,
                        std::span<const float> child_edge_sharpness) {
  float sum = 0.0F;
  int count = 0;
  const auto add = [&](float parent, float child) {
    if (!is_sharp(parent) || is_sharp(child)) return;
    sum += parent;
    ++count;
  };
  add(vertex_sharpness, child_vertex_sharpness);
  for (std::size_t i = 0; i < edge_sharpness.size(); ++i)
    add(edge_sharpness[i], child_edge_sharpness[i]);
  return count == 0 ? 0.0F : std::min(sum / static_cast<float>(count), 1.0F);
}

std::array<std::size_t, 2> crease_ends(std::span<const float> edge_sharpness) {
  std::size_t first = 0;
  while (!is_sharp(edge_sharpness[first]))
    ++first;
  std::size_t last = edge_sharpness.size() - 1;
  while (!is_sharp(edge_sharpness[last]))
    --last;
  return {first, last};
}

}  // namespace limes
