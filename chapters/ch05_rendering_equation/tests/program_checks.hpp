// What the tests of several chapters' programs ask alike.
#pragma once

#include <initializer_list>
#include <string>
#include <utility>

#include "ch01_pixels/tests/temporary_folder.hpp"
#include "ch05_rendering_equation/film.hpp"
#include "common/error.hpp"
#include "common/files.hpp"
#include "common/testkit/catch.hpp"

namespace lt::testing {

/// Every plot is drawn into a file that ends in svg, and has its word in it; none into another.
/// @param write  write(name, path) draws the plot `name`
/// @param words  name and word of each
template <class Write>
void check_plots(const Write& write,
                 std::initializer_list<std::pair<const char*, const char*>> words) {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(write(words.begin()->first, folder / "plot.png"), InputError);
  for (const auto& [name, word] : words) {
    CAPTURE(name);
    write(name, folder / "plot.svg");
    CHECK(read_file(folder / "plot.svg").find(word) != std::string::npos);
  }
}

/// The same samples in every pixel, to the last bit.
inline void require_same_samples(const Film& a, const Film& b) {
  REQUIRE(a.width() == b.width());
  REQUIRE(a.height() == b.height());
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      REQUIRE(a.at(x, y).sum == b.at(x, y).sum);
}

}  // namespace lt::testing
