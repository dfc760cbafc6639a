/// @file
/// A BSDF whose kind is known only when the ray has hit.
#pragma once

#include <variant>

#include "ch05_rendering_equation/bsdf.hpp"

namespace lt {

// [one-of]
/// One of several BSDFs. Which one is a number beside it, no pointer to a table: the compiler sees
/// all of them and puts each one's code in place.
template <Bsdf... Kinds>
struct OneOf {
  std::variant<Kinds...> kind;

  [[nodiscard]] Rgb eval(vec3 wo, vec3 wi) const {
    return std::visit([&](const auto& bsdf) { return bsdf.eval(wo, wi); }, kind);
  }
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    return std::visit([&](const auto& bsdf) { return bsdf.sample(wo, u); }, kind);
  }
  [[nodiscard]] float pdf(vec3 wo, vec3 wi) const {
    return std::visit([&](const auto& bsdf) { return bsdf.pdf(wo, wi); }, kind);
  }
};
// [one-of]

}  // namespace lt
