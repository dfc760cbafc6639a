#include "api.hpp"

#include <cmath>

namespace exercise {

Frame frame_around(glm::dvec3 /*normal*/) {
  TODO("find two unit vectors perpendicular to the normal and to each other");
}

glm::dvec3 bumped_normal(const Frame& /*frame*/, glm::ivec3 /*code*/) {
  TODO("turn the codes into a local normal, and that into a world normal");
}

}  // namespace exercise
