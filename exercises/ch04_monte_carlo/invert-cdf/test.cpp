#include "api.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "common/testkit/exercise.hpp"
#include "common/testkit/statistics.hpp"

namespace {

using exercise::exponential_pdf;
using exercise::parabola_pdf;
using exercise::sample_exponential;
using exercise::sample_parabola;
using lt::text_of;
using lt::text_of_u;
using Function = double (*)(double);

// A sampler with its density, and what both should be.
struct Task {
  std::string name;
  std::string sampler, pdf_name;
  Function sample, pdf;
  Function true_pdf, true_cdf;
  double end;  // beyond it there is no density, or none that counts: e^-50 is 2e-22
};

const Task parabola{"3 x^2",
                    "sample_parabola",
                    "parabola_pdf",
                    sample_parabola,
                    parabola_pdf,
                    [](double x) { return x < 0 || x > 1 ? 0 : 3 * x * x; },
                    [](double x) { return std::pow(std::clamp(x, 0.0, 1.0), 3); },
                    1};
const Task exponential{"e^-x",
                       "sample_exponential",
                       "exponential_pdf",
                       sample_exponential,
                       exponential_pdf,
                       [](double x) { return x < 0 ? 0 : std::exp(-x); },
                       [](double x) { return x < 0 ? 0 : -std::expm1(-x); },
                       50};

std::string gave(const std::string& function, double argument, double value,
                 const std::string& expected) {
  return function + "(" + text_of_u(argument) + ") gave " + text_of(value) + " and should give " +
         expected + ".";
}

bool is_near(double a, double b) {
  return std::abs(a - b) <= 1e-6;  // false for NaN
}

// Samples for 1,000 evenly spread u, sorted.
std::vector<double> even_samples(Function sample) {
  std::vector<double> all;
  for (int i = 0; i < 1000; ++i)
    all.push_back(sample((i + 0.5) / 1000));
  std::sort(all.begin(), all.end());
  return all;
}

// Do evenly spread u give samples with this distribution? Right ones keep within 0.0005 of it.
bool follow(const Task& task, const std::function<double(double)>& cdf) {
  const std::vector<double> all = even_samples(task.sample);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!(std::abs(cdf(all[i]) - (static_cast<double>(i) + 0.5) / 1000) < 0.002)) return false;
  return true;
}

// How many of the samples lie where, and how many should.
std::string quarters(const Task& task) {
  const std::vector<double> all = even_samples(task.sample);
  std::ostringstream text;
  text.precision(3);
  text << "for 1,000 evenly spread u, a quarter, half and three quarters of the samples lie below "
       << all[250] << ", " << all[500] << " and " << all[750] << ".";
  return text.str();
}

std::string right_quarters(const std::string& numbers) {
  return " It should be " + numbers + ".";
}

// The smallest u, the largest, and some between.
std::vector<double> awkward_u() {
  return {0.0, 0x1p-53, 0x1p-24, 1e-3, 0.25, 0.5, 0.75, 1 - 1e-3, 1 - 0x1p-24, 1 - 0x1p-53};
}

bool pdf_is_right(const Task& task, double x) {
  const double expected = task.true_pdf(x);
  const bool is_right = is_near(task.pdf(x), expected);
  if (!is_right) UNSCOPED_INFO(gave(task.pdf_name, x, task.pdf(x), text_of(expected)));
  return is_right;
}

// Mistakes in a density that have a name.
void diagnose_pdf(const Task& task) {
  const double at_half = task.pdf(0.5);
  const double at_three_quarters = task.pdf(0.75);
  lt::diagnose(
      !(is_near(at_half, task.true_cdf(0.5)) && is_near(at_three_quarters, task.true_cdf(0.75))),
      "cdf-for-pdf", gave(task.pdf_name, 0.75, at_three_quarters, text_of(task.true_pdf(0.75))));
  const double scale = at_half / task.true_pdf(0.5);
  const bool has_shape = scale > 0 && is_near(at_three_quarters, scale * task.true_pdf(0.75));
  const double area = lt::integrate(task.pdf, 0, task.end);
  lt::diagnose(!(has_shape && !is_near(scale, 1)), "pdf-not-normalised",
               "the area below " + task.pdf_name + " is " + text_of(area) + " and should be 1.");
  for (const double outside : {-0.25, -1.0, task.end == 1 ? 1.5 : -3.0})
    lt::diagnose(!(has_shape && task.pdf(outside) > 0), "pdf-goes-on-outside",
                 gave(task.pdf_name, outside, task.pdf(outside), "0"));
}

bool pdf_is_right_everywhere(const Task& task) {
  for (int i = -2000; i <= 4000; i += 7)  // not 0 and not 1: an end may count or not
    if (!pdf_is_right(task, i / 1000.0)) return false;
  return pdf_is_right(task, -1e-6) && pdf_is_right(task, 1 + 1e-6);
}

// Every u gives a sample by whose density one can divide.
bool one_can_divide(const Task& task) {
  for (const double u : awkward_u()) {
    const double x = task.sample(u);
    if (std::isfinite(x) && task.true_pdf(x) > 0) continue;
    UNSCOPED_INFO(gave(task.sampler, u, x, "a finite number whose density is not 0"));
    return false;
  }
  return true;
}

// The distribution for random u (Kolmogorov and Smirnov), and the mean.
bool is_right_at_random(const Task& task, std::uint64_t seed, double mean, double variance) {
  lt::TestRandom random(seed);
  std::vector<double> samples(10'000);
  lt::RunningMean running;
  for (double& x : samples) {
    x = task.sample(random.uniform());
    running.add(x);
  }
  const auto found = lt::kolmogorov_smirnov(samples, task.true_cdf);
  const double error = std::sqrt(variance / static_cast<double>(samples.size()));
  if (found.p_value > 1e-6 && lt::z_test(running.mean(), error, mean).agrees(0.01)) return true;
  UNSCOPED_INFO("10,000 random samples have the mean "
                << text_of(running.mean()) << ", and " << task.name << " has " << text_of(mean)
                << "; their distributions are up to " << text_of(found.distance) << " apart.");
  return false;
}

}  // namespace

TEST_CASE("parabola_pdf is 3 x^2 from 0 to 1, and its area is 1") {
  diagnose_pdf(parabola);
  REQUIRE(pdf_is_right_everywhere(parabola));
  REQUIRE(is_near(lt::integrate(parabola_pdf, 0, 1), 1));
}

TEST_CASE("exponential_pdf is e^-x from 0 on, and its area is 1") {
  diagnose_pdf(exponential);
  REQUIRE(pdf_is_right_everywhere(exponential));
  REQUIRE(is_near(lt::integrate(exponential_pdf, 0, exponential.end), 1));
}

TEST_CASE("sample_parabola has the density 3 x^2") {
  // Cube roots of 1/4, 1/2 and 3/4.
  const std::string seen = quarters(parabola) + right_quarters("0.63, 0.794 and 0.909");
  const std::vector<double> samples = even_samples(sample_parabola);
  lt::diagnose(!(samples.front() == 1 && samples.back() == 1), "one-third-is-zero", seen);
  lt::diagnose(!follow(parabola, [](double x) { return x * x; }), "square-root-for-cube-root",
               seen);
  lt::diagnose(!follow(parabola, [](double x) { return std::cbrt(x); }), "parabola-not-inverted",
               seen);
  const bool is_right = follow(parabola, parabola.true_cdf);
  if (!is_right) UNSCOPED_INFO(seen);
  REQUIRE(is_right);
  const double at_0 = sample_parabola(0);
  lt::diagnose(at_0 != 0, "density-zero-at-sample",
               gave("sample_parabola", 0, at_0, "a number whose density is not 0"));
  REQUIRE(one_can_divide(parabola));
  for (const auto seed : lt::seeds())
    REQUIRE(is_right_at_random(parabola, seed, 3.0 / 4, 3.0 / 5 - 9.0 / 16));
}

TEST_CASE("sample_exponential has the density e^-x") {
  // Logarithms of 4/3, 2 and 4.
  const std::string seen = quarters(exponential) + right_quarters("0.288, 0.693 and 1.39");
  lt::diagnose(!follow(exponential, [](double x) { return std::exp(x); }), "negative-samples",
               seen);
  lt::diagnose(!follow(exponential, [](double x) { return -std::log(1 - x); }),
               "exponential-not-inverted", seen);
  const bool is_right = follow(exponential, exponential.true_cdf);
  if (!is_right) UNSCOPED_INFO(seen);
  REQUIRE(is_right);
  const double at_0 = sample_exponential(0);
  lt::diagnose(!std::isinf(at_0), "log-of-zero",
               gave("sample_exponential", 0, at_0, "a finite number"));
  REQUIRE(one_can_divide(exponential));
  for (const auto seed : lt::seeds())
    REQUIRE(is_right_at_random(exponential, seed, 1, 1));
  std::ostringstream text;
  text.precision(3);
  text << "half of all light in fog gets farther than " << sample_exponential(0.5)
       << " mean free paths, the natural logarithm of 2";
  lt::measured(text.str());
}
