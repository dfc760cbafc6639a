#include <utility>

#include "common/error.hpp"
#include "common/files.hpp"
#include "common/plot.hpp"

namespace lt {

void add_dots_and_line(Plot& plot, Series measured, const std::string& label,
                       const std::function<double(double x)>& expected) {
  Series line{label, {}, {}, true, false, static_cast<int>(plot.series.size())};
  for (const double x : measured.x)
    line.add(x, expected(x));
  plot.series.push_back({"", std::move(measured.x), std::move(measured.y), false, true});
  plot.series.push_back(std::move(line));
}

void require_plot_path(const std::filesystem::path& path) {
  if (path.extension() == ".svg") return;
  throw InputError("--out: " + printable(path.string()) + " is no plot; end it in .svg");
}

}  // namespace lt
