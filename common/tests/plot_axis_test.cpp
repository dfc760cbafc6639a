#include "common/plot/axis.hpp"

#include <cmath>
#include <limits>

#include "common/testkit/catch.hpp"
#include "common/testkit/exercise.hpp"

namespace {

using Texts = std::vector<std::string>;

// The labels from the start to the end; "10" raised to "3" as 10^3, with plain signs.
Texts labels(const lt::Axis& axis) {
  Texts texts;
  for (const lt::Tick& tick : axis.ticks) {
    std::string text = tick.text + (tick.exponent.empty() ? "" : "^" + tick.exponent);
    for (const auto& [fancy, plain] :
         {std::pair<std::string, std::string>{"\u2212", "-"}, {"\u2009\u00d7\u2009", " x "}})
      for (auto at = text.find(fancy); at != text.npos; at = text.find(fancy))
        text.replace(at, fancy.size(), plain);
    texts.push_back(text);
  }
  return texts;
}

lt::Axis linear(double low, double high, bool round_out = false) {
  return lt::make_axis({low, high}, false, round_out, 5);
}

lt::Axis logarithmic(double low, double high, bool round_out = false) {
  return lt::make_axis({low, high}, true, round_out, 6);
}

}  // namespace

TEST_CASE("axis: linear ticks are 1, 2 or 5 times a power of ten apart") {
  CHECK(labels(linear(0, 1)) == Texts{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"});
  CHECK(labels(linear(0, 90)) == Texts{"0", "20", "40", "60", "80"});
  CHECK(labels(linear(-0.3, 0.3)) == Texts{"-0.2", "0.0", "0.2"});
  CHECK(labels(linear(17, 43)) == Texts{"20", "30", "40"});
  CHECK(labels(linear(0, 40000)) == Texts{"0", "10,000", "20,000", "30,000", "40,000"});
  CHECK(labels(linear(0.001, 0.0035)) ==
        Texts{"0.0010", "0.0015", "0.0020", "0.0025", "0.0030", "0.0035"});
}

TEST_CASE("axis: numbers too long to write out have an exponent") {
  CHECK(labels(linear(0, 4e6)) == Texts{"0", "1 x 10^6", "2 x 10^6", "3 x 10^6", "4 x 10^6"});
  CHECK(labels(linear(-5e-7, 5e-7)) ==
        Texts{"-4 x 10^-7", "-2 x 10^-7", "0", "2 x 10^-7", "4 x 10^-7"});
}

TEST_CASE("axis: rounding out ends at ticks and never grows what already ends there") {
  const lt::Axis grown = linear(0.13, 0.87, true);
  CHECK(grown.low == Approx(0.0).margin(1e-12));
  CHECK(grown.high == Approx(1.0));
  const lt::Axis kept = linear(0.2, 1.0, true);
  CHECK(kept.low == Approx(0.2));
  CHECK(kept.high == Approx(1.0));
}

TEST_CASE("axis: decades have labels, what lies between has faint lines") {
  const lt::Axis axis = logarithmic(1, 1000);
  CHECK(labels(axis) == Texts{"1", "10", "100", "1,000"});
  CHECK(axis.minor.size() == 3 * 8);
  CHECK(labels(logarithmic(1e-6, 1e-2)) == Texts{"10^-6", "10^-5", "10^-4", "10^-3", "10^-2"});
  // Too many for labels at each, and for lines between.
  const lt::Axis wide = logarithmic(1e-12, 1);
  CHECK(labels(wide) == Texts{"10^-12", "10^-9", "10^-6", "10^-3", "10^0"});
  CHECK(wide.minor.size() == 8);
}

TEST_CASE("axis: a logarithmic axis of less than two decades still has labels") {
  CHECK(labels(logarithmic(1, 20)) == Texts{"1", "2", "5", "10", "20"});
  CHECK(labels(logarithmic(0.3, 0.4)) == Texts{"0.3", "0.4"});
  CHECK(labels(logarithmic(3.1, 3.9)) == Texts{"3", "4"});
  CHECK(labels(logarithmic(30000, 90000)).size() >= 2);
}

TEST_CASE("axis: share goes from 0 to 1, in equal steps per decade on a logarithmic axis") {
  const lt::Axis linear_axis = linear(10, 20);
  CHECK(linear_axis.share(10) == 0);
  CHECK(linear_axis.share(20) == 1);
  CHECK(linear_axis.share(15) == 0.5);
  const lt::Axis log_axis = logarithmic(1, 10000);
  CHECK(log_axis.share(1) == 0);
  CHECK(log_axis.share(100) == Approx(0.5));
  CHECK(log_axis.share(10000) == Approx(1));
}

TEST_CASE("axis: what cannot be drawn does not count") {
  const double inf = std::numeric_limits<double>::infinity();
  const lt::Axis axis = lt::make_axis({-1, 0, 10, inf, std::nan(""), 1000}, true, false, 5);
  CHECK(axis.low == 10);
  CHECK(axis.high == 1000);
  CHECK_FALSE(lt::is_drawable(0, true));
  CHECK(lt::is_drawable(0, false));
  CHECK_FALSE(lt::is_drawable(-inf, false));
  CHECK_FALSE(lt::is_drawable(std::nan(""), false));
}

TEST_CASE("axis: no values, one value, and values that differ by rounding give a range") {
  for (const bool is_log : {false, true})
    for (const std::vector<double>& values :
         std::vector<std::vector<double>>{{}, {5}, {1e-9}, {1e100}, {1, 1 + 1e-15}}) {
      const lt::Axis axis = lt::make_axis(values, is_log, true, 5);
      CHECK(axis.high > axis.low);
      CHECK(axis.ticks.size() >= 2);
      CHECK(axis.ticks.size() <= 12);
    }
  CHECK(lt::make_axis({0}, false, true, 5).high > 0);
}

TEST_CASE("axis: any range has a few ticks, inside it, in order") {
  lt::TestRandom random(3);
  for (int round = 0; round < 3000; ++round) {
    const bool is_log = round % 2 == 1;
    const double a = std::pow(10, random.uniform(-20, 20));
    const double b =
        round % 3 == 0 ? a * random.uniform(1.0001, 3) : std::pow(10, random.uniform(-20, 20));
    const double sign = is_log || round % 5 != 0 ? 1 : -1;
    const lt::Axis axis = lt::make_axis({sign * a, b}, is_log, round % 7 < 3, 6);
    INFO(sign * a << " to " << b << (is_log ? ", log" : ""));
    for (const double end : {sign * a, b}) {
      REQUIRE(axis.share(end) > -1e-5);  // much less than a hundredth of a pixel
      REQUIRE(axis.share(end) < 1 + 1e-5);
    }
    REQUIRE(axis.ticks.size() >= 2);
    REQUIRE(axis.ticks.size() <= 12);
    for (std::size_t i = 0; i < axis.ticks.size(); ++i) {
      REQUIRE(axis.share(axis.ticks[i].value) > -1e-5);
      REQUIRE(axis.share(axis.ticks[i].value) < 1 + 1e-5);
      if (i > 0) REQUIRE(axis.ticks[i].value > axis.ticks[i - 1].value);
    }
  }
}
