#include "common/plot/end_labels.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/plot/text.hpp"

namespace lt {

namespace {

// Labels that touch, one below the other. Their best place, in the least-squares sense, is the
// mean of the places that its labels would choose for the whole group.
struct Group {
  double count, height, top;
};

void append(Group& above, const Group& below) {
  const double top_for_below = below.top - above.height;
  above.top = (above.count * above.top + below.count * top_for_below) / (above.count + below.count);
  above.height += below.height;
  above.count += below.count;
}

}  // namespace

double EndLabel::height() const {
  return static_cast<double>(lines.size()) * line_height;
}

void move_apart(std::vector<EndLabel>& labels, double top, double bottom) {
  std::stable_sort(labels.begin(), labels.end(), [](const EndLabel& a, const EndLabel& b) {
    return std::pair(std::round(a.end_y), a.before_y) < std::pair(std::round(b.end_y), b.before_y);
  });
  // Each label is a group; groups that overlap become one.
  std::vector<Group> groups;
  for (const EndLabel& label : labels) {
    const double wanted = label.end_y - label.height() / 2;
    groups.push_back(
        {1, label.height(), std::clamp(wanted, top, std::max(top, bottom - label.height()))});
    while (groups.size() > 1) {
      Group& above = groups[groups.size() - 2];
      if (above.top + above.height <= groups.back().top) break;
      append(above, groups.back());
      groups.pop_back();
    }
  }
  // Push groups in from the bottom, then from the top, which wins if there is no room for all.
  for (std::size_t i = groups.size(); i-- > 0;) {
    const double below = i + 1 < groups.size() ? groups[i + 1].top : bottom;
    groups[i].top = std::min(groups[i].top, below - groups[i].height);
  }
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const double above = i > 0 ? groups[i - 1].top + groups[i - 1].height : top;
    groups[i].top = std::max(groups[i].top, above);
  }
  // The labels' own places.
  auto label = labels.begin();
  for (const Group& group : groups) {
    double y = group.top;
    for (double i = 0; i < group.count; ++i, ++label) {
      label->y = y + label->height() / 2;
      y += label->height();
    }
  }
}

}  // namespace lt
