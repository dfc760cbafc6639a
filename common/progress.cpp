#include "common/progress.hpp"

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string_view>

namespace lt {

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto terminal_interval = std::chrono::milliseconds(100);
constexpr auto plain_interval = std::chrono::seconds(10);

bool stderr_is_terminal() {
#ifdef _WIN32
  return _isatty(2) != 0;
#else
  const char* kind = std::getenv("TERM");
  return isatty(2) != 0 && (kind == nullptr || std::string_view(kind) != "dumb");
#endif
}

// 3.2 s, 45 s, 2 min 05 s, 1 h 02 min
std::string in_words(double seconds) {
  std::ostringstream text;
  const auto whole = static_cast<long long>(seconds + 0.5);
  const auto two_digits = [](long long n) { return (n < 10 ? "0" : "") + std::to_string(n); };
  if (seconds < 9.95) {
    text.precision(1);
    text << std::fixed << seconds << " s";
  } else if (whole < 60) {
    text << whole << " s";
  } else if (whole < 3600) {
    text << whole / 60 << " min " << two_digits(whole % 60) << " s";
  } else {
    text << whole / 3600 << " h " << two_digits(whole / 60 % 60) << " min";
  }
  return text.str();
}

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Overwrites the line: spaces hide what an earlier, longer one left. It must not reach the width
// of a terminal, or it would wrap and stay.
void redraw(std::string line, bool last) {
  line.resize(78, ' ');
  std::cerr << '\r' << line << (last ? "\n" : "") << std::flush;
}

std::string bar(double share) {
  constexpr int width = 24;
  const int full = static_cast<int>(share * width);
  return "[" + std::string(full, '#') + std::string(width - full, '.') + "]";
}

}  // namespace

Progress::Progress(std::string label, std::int64_t total)
    : label_(std::move(label)),
      total_(std::max<std::int64_t>(total, 1)),
      start_(Clock::now()),
      shown_(start_),
      is_terminal_(stderr_is_terminal()) {
  if (is_terminal_) show(0, false);
}

Progress::~Progress() {
  const std::int64_t done = done_;
  if (done < total_) show(done, true);
}

void Progress::advance(std::int64_t units) {
  const std::int64_t done = done_ += units;
  const bool last = done >= total_ && done - units < total_;
  // Someone else is showing: skip, unless this is the end, which must be shown.
  std::unique_lock lock(mutex_, std::defer_lock);
  if (last) {
    lock.lock();
  } else if (!lock.try_lock()) {
    return;
  }
  const auto now = Clock::now();
  const bool is_due =
      is_terminal_ ? now - shown_ >= terminal_interval : now - shown_ >= plain_interval;
  if (!last && (!is_due || done_ >= total_)) return;
  shown_ = now;
  show(done, last);
}

void Progress::show(std::int64_t done, bool last) {
  const double elapsed = seconds_since(start_);
  const double share = std::min(1.0, static_cast<double>(done) / static_cast<double>(total_));
  const std::string percent = std::to_string(static_cast<int>(100 * share)) + " %";

  std::string line = label_ + ": ";
  if (last) {
    line += (share < 1 ? "stopped at " + percent + " after " : "done in ") + in_words(elapsed);
  } else {
    if (is_terminal_) line += bar(share) + " ";
    line += percent;
    if (share > 0) line += ", " + in_words(elapsed * (1 - share) / share) + " left";
  }
  if (is_terminal_) return redraw(line, last);
  std::cerr << line + "\n" << std::flush;
}

}  // namespace lt
