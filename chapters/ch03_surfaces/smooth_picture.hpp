/// @file
/// Anti-aliasing: a pixel is an area, so look at many points of it.
#pragma once

#include "ch01_pixels/image.hpp"
#include "ch02_ray_casting/camera.hpp"
#include "common/parallel.hpp"

namespace lt {

// [smooth-picture]
/// The picture that `camera` takes: each pixel is the mean over grid x grid points spread evenly
/// over its area. Mean of *linear* values, see chapter 1.
/// @param radiance_along  called with a Ray from several threads at once, returns an Rgb
template <class Function>
[[nodiscard]] Image smooth_picture(const Camera& camera, int width, int height, int grid,
                                   const Function& radiance_along) {
  Image image(width, height);
  const auto pixel = [&](int x, int y) {
    Rgb sum(0.0f);
    for (int j = 0; j < grid; ++j)
      for (int i = 0; i < grid; ++i) {
        const vec2 film = vec2(x, y) + (vec2(i, j) + 0.5f) / static_cast<float>(grid);
        sum += radiance_along(camera_ray(camera, film, width, height));
      }
    return sum / static_cast<float>(grid * grid);
  };
  for_each_tile(width, height, 0, [&](const Tile& tile) {
    for (int y = tile.y0; y < tile.y1; ++y)
      for (int x = tile.x0; x < tile.x1; ++x)
        image.at(x, y) = pixel(x, y);
  });
  return image;
}
// [smooth-picture]

}  // namespace lt
