/// @file
/// The two pictures that make a flat wall look like a real one.
#pragma once

#include "ch01_pixels/image.hpp"

namespace lt {

/// What a wall is made of, painted once. u goes right, v goes down, rows from the top; both
/// pictures tile without a seam in u and in v.
struct TextureMaps {
  Image color;    ///< linear reflectance, 0 to 1; it multiplies the material's tint
  Image normals;  ///< unit normals as (n + 1) / 2: red along +u, green along +v (down), blue out
};

}  // namespace lt
