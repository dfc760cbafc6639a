#include "common/plot/axis.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>

namespace lt {

namespace {

constexpr const char* minus = "\u2212";

// Below this share of the values' size a difference is rounding, not a range.
constexpr double smallest_relative_span = 1e-9;

std::string integer(long long value) {
  return (value < 0 ? minus : "") + std::to_string(std::llabs(value));
}

// `value` with a fixed number of decimals and commas between thousands.
std::string decimal(double value, int decimals) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::fixed << std::setprecision(decimals) << std::abs(value);
  std::string text = out.str();
  std::size_t point = std::min(text.find('.'), text.size());
  for (; point > 3; point -= 3)
    text.insert(point - 3, ",");
  const bool is_zero = text.find_first_not_of("0.,") == text.npos;
  return (value < 0 && !is_zero ? minus : "") + text;
}

int decade_of(double value) {
  return static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-9));
}

// A tick of a linear axis whose ticks are `step` apart.
Tick linear_tick(double value, double step, double largest) {
  const int step_decade = decade_of(step);
  if (largest < 1e6 && step_decade >= -4)
    return {value, decimal(value, std::max(0, -step_decade)), ""};
  if (value == 0) return {0, "0", ""};
  // Too long to write out: mantissa and exponent, with as many digits as the steps need.
  const int decade = decade_of(largest);
  const double mantissa = value / std::pow(10.0, decade);
  return {value, decimal(mantissa, std::max(0, decade - step_decade)) + "\u2009\u00d7\u200910",
          integer(decade)};
}

// The smallest of 1, 2, 5, 10, ... that is at least `rough`.
double nice_step(double rough) {
  const double decade = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * decade >= rough * (1 - 1e-9)) return factor * decade;
  return 10 * decade;
}

void add_linear_ticks(Axis& axis, bool round_out, int most_ticks) {
  const double step = nice_step((axis.high - axis.low) / most_ticks);
  const double slack = 1e-6;  // of a step: a tick that rounding has put just outside counts
  if (round_out) {
    axis.low = step * std::floor(axis.low / step + slack);
    axis.high = step * std::ceil(axis.high / step - slack);
  }
  const double first = std::ceil(axis.low / step - slack);
  const double last = std::floor(axis.high / step + slack);
  const double largest = step * std::max(std::abs(first), std::abs(last));
  for (double i = first; i <= last; ++i)
    axis.ticks.push_back(linear_tick(i * step, step, largest));
}

// The lines of a logarithmic axis: 1, 2, ... 9, 10, 20, ... between low and high.
struct LogLine {
  int digit;
  int decade;
  [[nodiscard]] double value() const { return digit * std::pow(10.0, decade); }
};

std::vector<LogLine> log_lines(double low, double high) {
  std::vector<LogLine> lines;
  for (int decade = decade_of(low); decade <= decade_of(high); ++decade)
    for (int digit = 1; digit <= 9; ++digit) {
      const LogLine line{digit, decade};
      if (line.value() >= low * (1 - 1e-9) && line.value() <= high * (1 + 1e-9))
        lines.push_back(line);
    }
  return lines;
}

Tick log_tick(const LogLine& line, bool written_out) {
  if (written_out) return {line.value(), decimal(line.value(), std::max(0, -line.decade)), ""};
  const std::string digit = line.digit == 1 ? "" : integer(line.digit) + "\u2009\u00d7\u2009";
  return {line.value(), digit + "10", integer(line.decade)};
}

// Moves low down and high up to the next 1, 2, ... 9 times a power of ten.
void round_out_log(Axis& axis) {
  const double low_decade = std::pow(10.0, decade_of(axis.low));
  const double high_decade = std::pow(10.0, decade_of(axis.high));
  axis.low = low_decade * std::floor(axis.low / low_decade + 1e-6);
  axis.high = high_decade * std::ceil(axis.high / high_decade - 1e-6);
}

void add_log_ticks(Axis& axis, bool round_out, int most_ticks) {
  if (round_out || log_lines(axis.low, axis.high).size() < 2) round_out_log(axis);
  const std::vector<LogLine> lines = log_lines(axis.low, axis.high);
  const auto is_decade = [](const LogLine& line) { return line.digit == 1; };
  const auto decades = static_cast<int>(std::count_if(lines.begin(), lines.end(), is_decade));

  // Powers of ten have labels; where they are few, so have 2 and 5; where even these are, all.
  const auto is_1_2_5 = [](const LogLine& line) { return 10 % line.digit == 0; };
  const bool only_decades = decades >= 3 || (decades == 2 && lines.size() > 14);
  const bool all = std::count_if(lines.begin(), lines.end(), is_1_2_5) < 2;
  const int every = only_decades ? (decades + most_ticks - 1) / most_ticks : 1;
  const bool written_out = axis.low >= 0.999e-3 && axis.high <= 1.001e4;
  for (const LogLine& line : lines) {
    const bool labelled =
        only_decades ? is_decade(line) && line.decade % every == 0 : all || is_1_2_5(line);
    if (labelled) {
      axis.ticks.push_back(log_tick(line, written_out));
    } else if (is_decade(line) || decades <= most_ticks) {
      axis.minor.push_back(line.value());
    }
  }
}

}  // namespace

double Axis::share(double value) const {
  if (is_log) return std::log(value / low) / std::log(high / low);
  return (value - low) / (high - low);
}

bool is_drawable(double value, bool is_log) {
  // The bounds keep differences and ratios of any two values finite.
  return std::abs(value) <= 1e150 && (!is_log || value >= 1e-150);
}

Axis make_axis(const std::vector<double>& values, bool is_log, bool round_out, int most_ticks) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double value : values) {
    if (!is_drawable(value, is_log)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  Axis axis{is_log, low, high, {}, {}};
  if (low > high) {
    axis.low = is_log ? 1 : 0;
    axis.high = is_log ? 10 : 1;
  } else if (high - low <= smallest_relative_span * std::max(std::abs(low), std::abs(high))) {
    // One value only: some room around it.
    const double room = low == 0 ? 1 : 0.5 * std::abs(low);
    axis.low = is_log ? low / 2 : low - room;
    axis.high = is_log ? high * 2 : high + room;
  }
  if (is_log) {
    add_log_ticks(axis, round_out, most_ticks);
  } else {
    add_linear_ticks(axis, round_out, most_ticks);
  }
  return axis;
}

}  // namespace lt
