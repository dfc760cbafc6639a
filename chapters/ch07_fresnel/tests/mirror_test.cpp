#include "ch07_fresnel/mirror.hpp"

#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"

using namespace lt;

static_assert(Bsdf<Mirror>);

TEST_CASE("mirror: it sends light where wo is mirrored and nowhere else") {
  const Mirror ball{gold};
  const auto sample = ball.sample({0.6f, 0.0f, 0.8f}, {0.1f, 0.9f, 0.5f});
  REQUIRE(sample);
  CHECK(sample->wi == close_to(vec3(-0.6f, 0.0f, 0.8f), 1e-7));
  CHECK(is_delta(*sample));
  CHECK(ball.eval({0.6f, 0.0f, 0.8f}, sample->wi) == Rgb(0.0f));
  CHECK(ball.pdf({0.6f, 0.0f, 0.8f}, sample->wi) == 0.0f);
  CHECK_FALSE(ball.sample({1, 0, 0}, vec3(0.0f)));
}

TEST_CASE("mirror: straight on the thesis' gold gives back 0.890914 of its tint") {
  // ((0.277 - 1)^2 + 2.92^2) / ((0.277 + 1)^2 + 2.92^2)
  const Mirror ball{{Rgb(0.277f), Rgb(2.92f)}, {1.0f, 0.851246f, 0.301305f}};
  const Rgb expected = 0.890914f * Rgb(1.0f, 0.851246f, 0.301305f);
  CHECK(ball.sample({0, 0, 1}, vec3(0.0f))->weight == close_to(expected, 1e-6));
}

TEST_CASE("mirror: gold is yellow, copper is redder, silver hardly has a color") {
  const auto straight_on = [](const Metal& metal) {
    return Mirror{metal}.sample({0, 0, 1}, vec3(0.0f))->weight;
  };
  // From the indices by the closed form, by hand: ((n-1)^2 + k^2) / ((n+1)^2 + k^2).
  CHECK(straight_on(gold) == close_to(Rgb(0.9310f, 0.7869f, 0.4015f), 1e-4));
  CHECK(straight_on(copper) == close_to(Rgb(0.8997f, 0.6195f, 0.5547f), 1e-4));
  CHECK(straight_on(silver) == close_to(Rgb(0.9869f, 0.9828f, 0.9786f), 1e-4));
}
