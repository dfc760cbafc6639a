// The sRGB curve and 8-bit codes. Reference values come from the formulas of IEC 61966-2-1, worked
// out with a calculator to ten digits.
#include "ch01_pixels/color.hpp"

#include <cmath>
#include <limits>

#include "common/testkit/catch.hpp"

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

// As a number: a test that fails would print a byte as a character.
int code_of(float linear) {
  return lt::to_code(linear);
}

float slope(float from, float to) {
  return (lt::encode_srgb(to) - lt::encode_srgb(from)) / (to - from);
}

}  // namespace

TEST_CASE("sRGB: encoding agrees with values worked out by hand") {
  CHECK(lt::encode_srgb(0.0f) == 0.0f);
  CHECK(lt::encode_srgb(0.001f) == Approx(0.01292).epsilon(1e-6));      // 12.92 * 0.001
  CHECK(lt::encode_srgb(0.18f) == Approx(0.4613561295).epsilon(1e-6));  // a grey card
  CHECK(lt::encode_srgb(0.5f) == Approx(0.7353569831).epsilon(1e-6));
  CHECK(lt::encode_srgb(1.0f) == Approx(1.0).epsilon(1e-6));
}

TEST_CASE("sRGB: decoding agrees with values worked out by hand") {
  CHECK(lt::decode_srgb(0.0f) == 0.0f);
  CHECK(lt::decode_srgb(0.01292f) == Approx(0.001).epsilon(1e-6));
  CHECK(lt::decode_srgb(0.1f) == Approx(0.0100228256).epsilon(1e-6));
  CHECK(lt::decode_srgb(0.5f) == Approx(0.2140411405).epsilon(1e-6));
  CHECK(lt::decode_srgb(1.0f) == Approx(1.0).epsilon(1e-6));
}

TEST_CASE("sRGB: decoding undoes encoding all the way from black to white") {
  for (int i = 0; i <= 10000; ++i) {
    const float linear = static_cast<float>(i) / 10000.0f;
    REQUIRE(lt::decode_srgb(lt::encode_srgb(linear)) == Approx(linear).epsilon(2e-6).margin(1e-9));
  }
}

TEST_CASE("sRGB: the line and the power meet without a gap") {
  // Exactly, the line ends 2.85e-8 above the power: 0.0031308 and 12.92 are rounded. A float near
  // 0.04 is good to 3.7e-9.
  const float below = 0.0031308f;
  const float above = std::nextafter(below, 1.0f);
  CHECK(std::abs(lt::encode_srgb(above) - lt::encode_srgb(below)) < 5e-8f);
  // On the way back they part by 2.3e-9.
  const float signal = 0.04045f;
  CHECK(std::abs(lt::decode_srgb(std::nextafter(signal, 1.0f)) - lt::decode_srgb(signal)) < 5e-9f);
}

TEST_CASE("sRGB: the slope falls by two percent where the line and the power meet") {
  // The derivative of the power at L is 1.055 / 2.4 * L^(1/2.4 - 1): 12.5955 at L = 0.0031768, the
  // middle of the interval.
  CHECK(slope(0.0030308f, 0.0031308f) == Approx(12.92).epsilon(1e-3));
  CHECK(slope(0.0031309f, 0.0032227f) == Approx(12.5955).epsilon(1e-3));
}

TEST_CASE("sRGB: the line of the standard is the tangent to its power that runs through zero") {
  // README (1.4): the tangent touches where the signal is a / (gamma - 1).
  const double a = 0.055;
  const double gamma = 2.4;
  const double signal = a / (gamma - 1.0);
  const double linear = std::pow((signal + a) / (1.0 + a), gamma);
  const double touching_slope = (1.0 + a) / gamma * std::pow(linear, 1.0 / gamma - 1.0);
  CHECK(touching_slope == Approx(signal / linear).epsilon(1e-12));  // touches and runs through 0
  CHECK(lt::encode_srgb(0.001f) / 0.001f == Approx(touching_slope).epsilon(3e-4));  // 12.92
}

TEST_CASE("sRGB: the borders that older texts print give the same codes") {
  // The proposal of 1996 put them at light 0.00304 and signal 0.03928: README (1.4), cut off.
  // Between those and the standard's, line and power both give codes 10.01 to 10.31.
  for (float light = 0.00304f; light < 0.0031308f; light += 1e-6f) {
    const double power = 1.055 * std::pow(double{light}, 1.0 / 2.4) - 0.055;
    REQUIRE(code_of(light) == std::lround(255.0 * power));
  }
  for (int code = 0; code < 256; ++code) {
    const double signal = code / 255.0;
    REQUIRE((signal <= 0.03928) == (signal <= 0.04045));  // the same branch
  }
}

TEST_CASE("codes: black - nearly black - half the light - white") {
  CHECK(code_of(0.0f) == 0);
  CHECK(code_of(0.001f) == 3);  // 255 * 0.01292 = 3.29
  CHECK(code_of(0.5f) == 188);  // 255 * 0.73536 = 187.516: truncated it would be 187
  CHECK(code_of(1.0f) == 255);
}

TEST_CASE("codes: what no screen can show ends at the nearer end") {
  CHECK(code_of(1.0001f) == 255);
  CHECK(code_of(2.0f) == 255);
  CHECK(code_of(lt::infinity) == 255);
  CHECK(code_of(-1e-30f) == 0);
  CHECK(code_of(-1.0f) == 0);
  CHECK(code_of(-lt::infinity) == 0);
  CHECK(code_of(not_a_number) == 0);
  CHECK(code_of(-not_a_number) == 0);
}

TEST_CASE("codes: all 256 survive the way to light and back") {
  for (int code = 0; code < 256; ++code)
    REQUIRE(code_of(lt::from_code(static_cast<std::uint8_t>(code))) == code);
}

TEST_CASE("codes: light goes to the nearest code") {
  // The border between two codes lies at the signal half-way between them, wherever that is.
  for (int code = 0; code < 255; ++code) {
    const float border = (static_cast<float>(code) + 0.5f) / 255.0f;
    REQUIRE(code_of(lt::decode_srgb(border - 1e-5f)) == code);
    REQUIRE(code_of(lt::decode_srgb(border + 1e-5f)) == code + 1);
  }
}

TEST_CASE("codes: more light never has a smaller code") {
  int before = 0;
  for (int i = 0; i <= 20000; ++i) {
    const int code = code_of(static_cast<float>(i) / 16000.0f);  // 0 to 1.25
    REQUIRE(code >= before);
    before = code;
  }
  CHECK(before == 255);
}

TEST_CASE("codes: a code taken for light is far too bright") {
  // Code 128 stands for 0.21586 of white; divided by 255 it reads 0.50196: 2.33 times too much.
  CHECK(lt::from_code(128) == Approx(0.2158605).epsilon(1e-6));
  CHECK(128.0f / 255.0f / lt::from_code(128) == Approx(2.3254).epsilon(1e-4));
  CHECK(code_of(128.0f / 255.0f) == 188);  // and encoded again, it is washed out
}
