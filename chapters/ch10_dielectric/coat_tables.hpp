/// @file
/// The albedos of all coats in a scene, and bases that need them.
#pragma once

#include <cassert>
#include <memory>
#include <utility>
#include <vector>

#include "ch10_dielectric/coated_bsdf.hpp"

namespace lt {

// [coat-tables]
/// One table for each kind of coat in a scene. A scene has few: one looks through all of them.
class CoatTables {
 public:
  explicit CoatTables(const TexturedScene& scene) {
    for (const Look& look : scene.looks) {
      const auto& [roughness, ior] = std::pair(look.material.roughness, look.material.ior);
      if (is_coated(look.material) && !find(roughness, ior))
        coats_.push_back({roughness, ior, SpecularAlbedo(roughness, ior)});
    }
  }

  /// @param material  coated, and of the scene; a texture may have changed its tint
  [[nodiscard]] const SpecularAlbedo& of(const Material& material) const {
    const SpecularAlbedo* found = find(material.roughness, material.ior);
    assert(found);
    return *found;
  }

 private:
  struct Known {
    float roughness, ior;
    SpecularAlbedo albedo;
  };

  [[nodiscard]] const SpecularAlbedo* find(float roughness, float ior) const {
    for (const Known& coat : coats_)
      if (coat.roughness == roughness && coat.ior == ior) return &coat.albedo;
    return nullptr;
  }

  std::vector<Known> coats_;
};
// [coat-tables]

// [conserving-at]
/// coated_bsdf_at() with bases that lose nothing.
struct ConservingScattering {
  std::shared_ptr<const CoatTables> tables;

  [[nodiscard]] CoatedBsdf<ConservingBase> operator()(const Surface& surface) const {
    const auto base_of = [&](const Material& material) {
      return ConservingBase{material.tint, material.specular, tables->of(material)};
    };
    return coated_with(base_of, surface);
  }
};
// [conserving-at]

/// coated_bsdf_at() with the thesis' bases.
[[nodiscard]] inline CoatedBsdf<ThesisBase> thesis_bsdf_at(const Surface& surface) {
  const auto base_of = [](const Material& material) {
    return ThesisBase{material.tint, coat_of(material)};
  };
  return coated_with(base_of, surface);
}

}  // namespace lt
