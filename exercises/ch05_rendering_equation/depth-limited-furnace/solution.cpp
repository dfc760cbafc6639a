#include "api.hpp"

namespace exercise {

Rgb radiance(const Scene& scene, const Ray& ray, int depth, Random& random) {
  Rgb light(0.0);       // gathered so far
  Rgb throughput(1.0);  // what is left of light on its way back from here to the camera
  Ray next = ray;
  for (int bounces = 0;; ++bounces) {
    const auto surface = closest_hit(scene, next);
    if (!surface) return light + throughput * background(scene, next.direction);

    // Its own light has not been scattered here: the throughput is still that of the way so far.
    light += throughput * surface->emission;
    if (bounces == depth) return light;

    const glm::dvec3 u = random.next_vec3();
    const auto sample = sample_bsdf(scene, *surface, -next.direction, u);
    if (!sample) return light;
    throughput *= sample->weight;
    next = {surface->position, sample->wi};
  }
}

}  // namespace exercise
