#include "common/option_use.hpp"

#include <algorithm>

#include "common/error.hpp"

namespace lt {

namespace {

// "a, b or c"
std::string any_of(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 < words.size() ? ", " : " or ") + words[i];
  return text;
}

}  // namespace

void require_use(const OptionUse& use, bool other_given, const std::string& chosen) {
  const auto& [name, other, choices] = use;
  if (choices.empty()) {
    if (other_given) return;
    throw InputError(name + " needs " + other + "; add it, or leave " + name + " out");
  }
  if (std::ranges::find(choices, chosen) != choices.end()) return;
  throw InputError(name + " is for " + other + " " + any_of(choices) + "; leave it out for " +
                   other + " " + chosen);
}

}  // namespace lt
