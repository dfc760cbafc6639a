#include "common/testkit/exercise.hpp"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <numbers>
#include <numeric>
#include <sstream>

#include "common/error.hpp"

// A body that still says TODO(...): tell the runner where.
CATCH_TRANSLATE_EXCEPTION(const lt::NotWritten& missing) {
  std::cout << "[not-written] " << missing.file << ':' << missing.line << ": " << missing.what()
            << std::endl;
  return "not written yet: " + std::string(missing.what());
}

namespace lt {

void diagnose(bool is_right, std::string_view tag, const std::string& seen) {
  if (is_right) {
    SUCCEED("not the mistake " << tag);
    return;
  }
  std::cout << "[diag:" << tag << "] " << seen << std::endl;
  FAIL(tag << ": " << seen);
}

void measured(const std::string& text) {
  std::cout << "[measured] " << text << std::endl;
}

std::string text_of(double x, int digits) {
  std::ostringstream text;
  text.precision(digits);
  text << (std::isnan(x) ? std::abs(x) : x);  // "-nan" says no more than "nan"
  return text.str();
}

std::string text_of(glm::dvec3 v) {
  return '(' + text_of(v.x) + ", " + text_of(v.y) + ", " + text_of(v.z) + ')';
}

std::string text_of_u(double u) {
  if (u == 1 - 0x1p-53) return "1 - 2^-53";
  return u == 1 - 0x1p-24 ? "1 - 2^-24" : text_of(u);
}

std::vector<std::uint64_t> seeds() {
  std::uint64_t count = 1;
  if (const char* text = std::getenv("LT_FAIR_SEEDS")) {
    const std::string_view digits(text);
    const auto [end, error] = std::from_chars(digits.begin(), digits.end(), count);
    if (error != std::errc() || end != digits.end() || count < 1 || count > 10'000'000)
      throw InputError("LT_FAIR_SEEDS takes a whole number from 1 to 10000000");
  }
  std::vector<std::uint64_t> all(count);
  std::iota(all.begin(), all.end(), std::uint64_t{1});
  return all;
}

std::uint64_t TestRandom::next_bits() {
  // SplitMix64 (Steele, Lea and Flood 2014)
  std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
  z = (z ^ z >> 27) * 0x94d049bb133111ebu;
  return z ^ z >> 31;
}

double TestRandom::uniform(double low, double high) {
  const double unit = static_cast<double>(next_bits() >> 11) * 0x1p-53;
  const double value = low + (high - low) * unit;
  return value < high ? value : std::nextafter(high, low);  // the sum may round up to `high`
}

glm::dvec3 TestRandom::direction() {
  const double z = uniform(-1, 1);
  const double phi = uniform(0, 2 * std::numbers::pi);
  const double radius = std::sqrt(1 - z * z);
  return {radius * std::cos(phi), radius * std::sin(phi), z};
}

}  // namespace lt
