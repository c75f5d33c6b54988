// Random places on a surface, the same for every library.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace bench {

struct Location {
  int face;  // or quadrant: faces in order, a polygon that is no quad has one quadrant per corner
  float u, v;
};

/// n places with uniform parameters, by face if sorted (the pattern of a tessellation).
inline std::vector<Location> random_locations(int faces, std::size_t n, bool triangular,
                                              bool sorted) {
  std::uint64_t state = 12345;
  auto next = [&] {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return double(state >> 11) * 0x1p-53;
  };
  std::vector<Location> out(n);
  for (Location& l : out) {
    l.face = std::min(faces - 1, int(next() * faces));
    l.u = float(next());
    l.v = float(next());
    if (triangular && l.u + l.v > 1) {
      l.u = 1 - l.u;
      l.v = 1 - l.v;
    }
  }
  if (sorted)
    std::stable_sort(out.begin(), out.end(),
                     [](const Location& a, const Location& b) { return a.face < b.face; });
  return out;
}

}  // namespace bench
