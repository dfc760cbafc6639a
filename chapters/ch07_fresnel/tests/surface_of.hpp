/// @file
/// A surface of a material, for tests of what light does there.
#pragma once

#include "ch03_surfaces/surface.hpp"

namespace lt::testing {

/// @param outside  false: hit from inside
[[nodiscard]] inline Surface surface_of(const Material& material, bool outside = true) {
  Surface surface{};
  surface.outside = outside;
  surface.material = material;
  return surface;
}

}  // namespace lt::testing
