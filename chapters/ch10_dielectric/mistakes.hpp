/// @file
/// Mistakes to look at. The pictures of `--wrong` are made with them; nothing else uses them.
#pragma once

#include "ch10_dielectric/coated_bsdf.hpp"

namespace lt::mistakes {

// [base-not-attenuated]
/// Lays a coat over the matt surface of the chapters before, which still gets all of the light: the
/// share that the coat reflects is given back twice.
struct BareBase {
  Rgb albedo;  ///< 0 to 1

  [[nodiscard]] Rgb eval(vec3 wo, vec3 wi) const { return lambert(albedo, wo, wi); }
  [[nodiscard]] float share(vec3 /*wo*/) const { return mean_channel(albedo); }
};

using CoatOverBareBase = CoatedDiffuse<BareBase>;
// [base-not-attenuated]

// [density-of-chosen]
/// Divides the sum of both lobes by the density of the one that was chosen. The mean is right! But
/// where one lobe happens to propose a direction of the other, that one's f is divided by a density
/// which has next to nothing there; and no direction comes with the density that it says.
struct DensityOfChosen : CoatedDiffuse<ReciprocalBase> {
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    auto right = CoatedDiffuse::sample(wo, u);
    if (!right) return right;
    const bool is_coat = u.z < coat_probability(wo);
    const float chosen = is_coat ? coat.pdf(wo, right->wi) : cosine_hemisphere_pdf(right->wi.z);
    return BsdfSample{right->wi, right->weight * (right->pdf / chosen), chosen};
  }
};
// [density-of-chosen]

// [not-divided]
/// Takes one of two lobes, and forgets that it takes it only sometimes. All that is seen is a mean
/// of both where there should be the sum.
struct NotDividedByP : CoatedDiffuse<ReciprocalBase> {
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    if (u.z < coat_probability(wo)) return coat.sample(wo, u);
    const vec3 wi = cosine_hemisphere(vec2(u));
    return BsdfSample{wi, base.eval(wo, wi) * pi, cosine_hemisphere_pdf(wi.z)};
  }
};
// [not-divided]

[[nodiscard]] inline CoatedDiffuse<ReciprocalBase> right_coat_of(const Material& material) {
  const CoatFresnel fresnel = coat_of(material);
  return {{{alpha_of(material.roughness)}, fresnel}, {material.tint, fresnel}};
}
[[nodiscard]] inline CoatOverBareBase bare_base_of(const Material& material) {
  return {right_coat_of(material).coat, {material.tint}};
}
[[nodiscard]] inline DensityOfChosen density_of_chosen_of(const Material& material) {
  return {right_coat_of(material)};
}
[[nodiscard]] inline NotDividedByP not_divided_of(const Material& material) {
  return {right_coat_of(material)};
}

// [with-coat]
/// coated_bsdf_at() with other coats, made by `coated_from(material)`; none of them is polished.
template <class CoatedFrom>
[[nodiscard]] auto with_coat(const CoatedFrom& coated_from) {
  return [coated_from](const Surface& surface) {
    using Wrong = decltype(coated_from(surface.material));
    using WrongBsdf =
        OneOf<Wrong, CosineLambert, Mirror, Glass, MetalReflection<>, PlasticReflection<>>;
    if (is_coated(surface.material)) return WrongBsdf{coated_from(surface.material)};
    return std::visit([](const auto& other) { return WrongBsdf{other}; },
                      rough_bsdf_at(surface).kind);
  };
}
// [with-coat]

}  // namespace lt::mistakes
