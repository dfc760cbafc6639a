#include "common/parallel.hpp"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "common/testkit/catch.hpp"

namespace {

// How often each pixel was in a tile, from tiles worked on by several threads.
std::vector<int> visits(int width, int height, int threads, int tile_size) {
  std::vector<std::atomic<int>> counts(static_cast<std::size_t>(width) * height);
  lt::for_each_tile(
      width, height, threads,
      [&](const lt::Tile& tile) {
        for (int y = tile.y0; y < tile.y1; ++y)
          for (int x = tile.x0; x < tile.x1; ++x)
            ++counts.at(static_cast<std::size_t>(y) * width + x);
      },
      tile_size);
  std::vector<int> result;
  for (const std::atomic<int>& count : counts)
    result.push_back(count);
  return result;
}

}  // namespace

TEST_CASE("tiles: every pixel is in exactly one, whatever the sizes and the threads") {
  for (const int width : {1, 2, 31, 32, 33, 100})
    for (const int height : {1, 7, 32, 65})
      for (const int tile_size : {1, 8, 32, 1000})
        for (const int threads : {0, 1, 2, 5}) {
          const std::vector<int> counts = visits(width, height, threads, tile_size);
          if (counts != std::vector<int>(counts.size(), 1))
            FAIL(width << " x " << height << ", tiles of " << tile_size << ", " << threads
                       << " threads");
        }
}

TEST_CASE("tiles: none is empty or larger than asked, and an empty picture has none") {
  lt::for_each_tile(33, 17, 1, [](const lt::Tile& tile) {
    CHECK(tile.x1 > tile.x0);
    CHECK(tile.y1 > tile.y0);
    CHECK(tile.x1 - tile.x0 <= 32);
    CHECK(tile.y1 - tile.y0 <= 32);
  });
  lt::for_each_tile(0, 5, 4, [](const lt::Tile&) { FAIL("a tile of nothing"); });
}

TEST_CASE("tiles: what a tile throws arrives, once all threads have stopped") {
  for (const int threads : {1, 4}) {
    std::atomic<int> working{0};
    std::atomic<int> calls{0};
    const auto work = [&](const lt::Tile&) {
      ++working;
      const int call = ++calls;
      --working;
      if (call == 3) throw std::runtime_error("tile three");
      // The thread that throws may lose its processor just before; the others must not meanwhile
      // be done with everything.
      if (call > 3) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    };
    std::string message;
    try {
      lt::for_each_tile(1000, 1000, threads, work, 10);
    } catch (const std::runtime_error& error) {
      message = error.what();
    }
    CHECK(message == "tile three");
    CHECK(working == 0);
    CHECK(calls < 100 * 100);  // the rest was not begun
  }
}

TEST_CASE("tiles: no threads asked for means at least one") {
  CHECK(lt::thread_count(0) >= 1);
  CHECK(lt::thread_count(3) == 3);
}
