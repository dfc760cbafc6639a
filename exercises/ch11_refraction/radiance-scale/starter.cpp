#include "api.hpp"

namespace exercise {

double crossing_scale(double /*n_here*/, double /*n_beyond*/, Transport /*transport*/) {
  TODO("say how radiance changes where it comes through a surface, and what energy does there");
}

Choice choose(double /*share*/, double /*u*/, double /*n_here*/, double /*n_beyond*/,
              Transport /*transport*/) {
  TODO("reflect with the probability share, and say what is left to weigh");
}

double light_at_camera(double /*light*/, std::span<const double> /*indices*/) {
  TODO("follow the path from the camera to the light, crossing by crossing");
}

}  // namespace exercise
