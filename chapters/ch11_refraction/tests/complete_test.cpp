#include "ch11_refraction/complete.hpp"

#include "ch07_fresnel/tests/surface_of.hpp"
#include "ch11_refraction/glass_scenes.hpp"
#include "ch11_refraction/tests/glasses.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

template <class T>
bool is_a(const Material& material) {
  return std::holds_alternative<T>(complete_bsdf_at(surface_of(material)).kind);
}

const Material frosted{.roughness = 0.2f, .ior = 1.5f, .attenuation = Rgb(0.0f)};

}  // namespace

static_assert(Bsdf<CompleteBsdf>);

TEST_CASE("complete: clear dielectrics are as rough as they say, and deltas where polished") {
  CHECK(is_a<RoughGlass<>>(frosted));
  CHECK(is_a<Glass>({.roughness = 0.0f, .ior = 1.5f, .attenuation = Rgb(0.0f)}));
  CHECK(is_a<RoughGlass<>>({.roughness = 0.001f, .ior = 1.5f, .attenuation = Rgb(0.0f)}));
}

TEST_CASE("complete: where the indices hardly differ there is nothing for facets to bend at") {
  CHECK(is_a<Glass>({.roughness = 0.2f, .ior = 1.0f, .attenuation = Rgb(0.0f)}));
  CHECK(is_a<Glass>({.roughness = 0.2f, .ior = 1.00005f, .attenuation = Rgb(0.0f)}));
  CHECK(is_a<RoughGlass<>>({.roughness = 0.2f, .ior = 1.001f, .attenuation = Rgb(0.0f)}));
}

TEST_CASE("complete: all others are chapter 10's") {
  CHECK(is_a<CoatedDiffuse<ReciprocalBase>>({.roughness = 0.5f}));
  CHECK(is_a<PolishedDiffuse<ReciprocalBase>>({.roughness = 0.0f}));
  CHECK(is_a<CosineLambert>({.specular = 0.0f}));
  CHECK(is_a<PlasticReflection<>>({.type = MaterialType::plastic}));
  CHECK(is_a<MetalReflection<>>({.extinction = 3.0f, .type = MaterialType::metal}));
  CHECK(is_a<Mirror>({.roughness = 0.0f, .extinction = 3.0f, .type = MaterialType::metal}));
}

TEST_CASE("complete: inside, the indices are exchanged") {
  const RoughGlass<> in = rough_glass_at(surface_of(frosted));
  const RoughGlass<> out = rough_glass_at(surface_of(frosted, false));
  CHECK(in.ggx.alpha == 0.2f);
  CHECK(in.n_here == 1.0f);
  CHECK(in.n_beyond == 1.5f);
  CHECK(out.n_here == 1.5f);
  CHECK(out.n_beyond == 1.0f);
}

TEST_CASE("complete room: the clear sphere is the thesis', or as one likes") {
  const Material thesis = complete_room(16).looks[room::clear_sphere].material;
  CHECK(thesis.ior == 1.04f);
  CHECK(thesis.roughness == 0.002f);
  CHECK(thesis.attenuation == Rgb(0.0f, 1.0f, 0.666f));
  CHECK(is_a<RoughGlass<>>(thesis));
  const Material other = complete_room(16, {1.5f, 0.3f, 2.0f}).looks[room::clear_sphere].material;
  CHECK(other.ior == 1.5f);
  CHECK(other.roughness == 0.3f);
  CHECK(other.attenuation.g == 2.0f);
}
