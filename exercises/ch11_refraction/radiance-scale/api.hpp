/// @file
/// Exercise 11.2: what you write and what the checker calls. "Here" is the side of wo, which points
/// back along the path; "beyond" is the other side.
#pragma once

#include <span>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// What a path carries.
enum class Transport {
  radiance,   ///< it began at the camera and looks for light: what comes back along it is radiance
  importance  ///< it began at a light and carries energy along
};

/// What a path's weight is multiplied by where it crosses a smooth surface, Fresnel left out.
/// @param n_here, n_beyond  indices of refraction, greater than 0
[[nodiscard]] double crossing_scale(double n_here, double n_beyond, Transport transport);

/// How a path goes on.
struct Choice {
  bool goes_through;  ///< otherwise it is reflected
  double weight;      ///< what the path's weight is multiplied by
};

/// Chooses between both ways at a smooth clear surface, each as often as it has light.
/// @param share  of the light that is reflected (Fresnel), 0 to 1
/// @param u      a random number in [0, 1)
[[nodiscard]] Choice choose(double share, double u, double n_here, double n_beyond,
                            Transport transport);

/// The radiance that a camera sees of a light, through clear surfaces that reflect nothing.
/// @param light    radiance of the light in its own medium
/// @param indices  of the media along the path, from the camera's to the light's; not empty
[[nodiscard]] double light_at_camera(double light, std::span<const double> indices);

}  // namespace exercise
