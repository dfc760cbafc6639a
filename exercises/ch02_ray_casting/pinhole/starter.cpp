#include "api.hpp"

#include <cmath>

namespace exercise {

Camera look_at(glm::vec3 /*position*/, glm::vec3 /*target*/, glm::vec3 /*up*/,
               float /*field_of_view*/) {
  TODO("find forward, right and up of a camera that looks at the target");
}

Ray camera_ray(const Camera& /*camera*/, glm::ivec2 /*pixel*/, glm::vec2 /*offset*/, int /*width*/,
               int /*height*/) {
  TODO("aim a ray from the pinhole through a point of the pixel");
}

}  // namespace exercise
