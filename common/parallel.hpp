/// @file
/// One job for all processors: numbered pieces of work, or the tiles of a picture.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace lt {

/// A rectangle of pixels: x from x0 to x1 - 1, y from y0 to y1 - 1.
struct Tile {
  int x0, y0, x1, y1;
};

/// @param requested  threads asked for; 0 means one for each processor
/// @return at least 1
[[nodiscard]] inline int thread_count(int requested) {
  return requested > 0 ? requested
                       : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Calls `work(i)` once for each i from 0 to count - 1, from several threads, each taking the next
/// i when it has finished one.
/// @param threads  0: one for each processor
/// @throws whatever `work` throws first, after all threads have stopped
template <class Work>
void for_each_index(int count, int threads, const Work& work) {
  std::atomic<int> next{0};
  std::exception_ptr error;
  std::mutex error_mutex;

  const auto worker = [&] {
    try {
      for (int i = next++; i < count; i = next++) {
        work(i);
      }
    } catch (...) {
      const std::lock_guard lock(error_mutex);
      if (!error) error = std::current_exception();
      next = count;
    }
  };

  std::vector<std::thread> pool;
  try {
    for (int i = 1; i < std::min(thread_count(threads), count); ++i)
      pool.emplace_back(worker);
  } catch (const std::system_error&) {
    // The machine gives no more threads: those that there are do the same work.
  }
  worker();
  for (std::thread& thread : pool)
    thread.join();
  if (error) std::rethrow_exception(error);
}

/// Calls `work(Tile)` once for each tile of a width x height picture, from several threads. Tiles
/// do not overlap and cover the picture.
/// @param threads    0: one for each processor
/// @param tile_size  side of a tile in pixels, >= 1
/// @throws whatever `work` throws first, after all threads have stopped
template <class Work>
void for_each_tile(int width, int height, int threads, const Work& work, int tile_size = 32) {
  const int columns = (width + tile_size - 1) / tile_size;
  const int rows = (height + tile_size - 1) / tile_size;
  for_each_index(columns * rows, threads, [&](int i) {
    const int x0 = i % columns * tile_size;
    const int y0 = i / columns * tile_size;
    work(Tile{x0, y0, std::min(x0 + tile_size, width), std::min(y0 + tile_size, height)});
  });
}

}  // namespace lt
