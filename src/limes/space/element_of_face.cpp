#include "limes/space/element_of_face.h"

namespace limes {

std::vector<int> element_of_face(const SubdivisionSpace& space) {
  std::vector<int> out(static_cast<std::size_t>(space.mesh().topology.num_faces()), -1);
  for (std::size_t e = 0; e < space.elements().size(); ++e) {
    int& first = out[static_cast<std::size_t>(space.elements()[e].face.value)];
    if (first < 0) first = static_cast<int>(e);
  }
  return out;
}

}  // namespace limes
