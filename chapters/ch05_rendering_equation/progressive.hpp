/// @file
/// Pictures that get better while one watches, and how noisy they still are.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "ch05_rendering_equation/render.hpp"

namespace lt {

// [noise]
/// Standard error of a film's pixels, W/(m^2 sr), root mean square over pixels and colours.
/// Measured, without knowing the right picture, from how far the newest samples and all earlier
/// ones disagree: two independent estimates from n and m samples differ by sigma^2 (1/n + 1/m) in
/// the mean square, and all n + m together err by sigma^2 / (n + m).
/// @param before  the film before its newest samples
/// @param film    the same with them
/// @return nothing while no pixel has samples of both kinds
[[nodiscard]] inline std::optional<double> pixel_noise(const Film& before, const Film& film) {
  double sum = 0;
  double pixels = 0;
  for (int y = 0; y < film.height(); ++y)
    for (int x = 0; x < film.width(); ++x) {
      const FilmPixel& older = before.at(x, y);
      const FilmPixel& all = film.at(x, y);
      const auto n = static_cast<double>(older.count);
      const auto m = static_cast<double>(all.count - older.count);
      if (n == 0 || m == 0) continue;
      const glm::dvec3 difference = older.sum / n - (all.sum - older.sum) / m;
      sum += dot(difference, difference) / 3 * (n * m) / ((n + m) * (n + m));
      ++pixels;
    }
  if (pixels == 0) return std::nullopt;
  return std::sqrt(sum / pixels);
}
// [noise]

// [progressive]
/// Takes `samples` samples of every pixel in passes of 1, 1, 2, 4, 8, ...: each pass doubles what
/// is there. The film is the same, bit for bit, as after one pass of them all.
/// @param range       seed, threads and tiles; its first and last are not used
/// @param after_pass  called with the film before and after each pass, the last one perhaps cut
///                    short by `cancel`
template <RadianceEstimator Estimator, class AfterPass>
void render_in_passes(Film& film, const Camera& camera, const Estimator& estimate, int samples,
                      SampleRange range, const std::atomic<bool>& cancel,
                      const AfterPass& after_pass, Progress* progress = nullptr) {
  for (int done = 0; done < samples && !cancel; done = range.last) {
    range.first = done;
    range.last = std::min(samples, std::max(1, 2 * done));
    const Film before = film;
    render(film, camera, estimate, range, cancel, progress);
    after_pass(before, film);
  }
}
// [progressive]

}  // namespace lt
