#include "runner/pattern.hpp"

#include <regex>

namespace lt {

struct Pattern::Compiled {
  std::regex expression;
};

Pattern::Pattern(const char* expression)
    : compiled_(std::make_unique<Compiled>(Compiled{std::regex(expression)})) {}

Pattern::~Pattern() = default;

std::optional<Pattern::Groups> Pattern::match(const std::string& text) const {
  std::smatch found;
  if (!std::regex_match(text, found, compiled_->expression)) return std::nullopt;
  return Groups(found.begin(), found.end());
}

std::optional<Pattern::Groups> Pattern::search(const std::string& text) const {
  std::smatch found;
  if (!std::regex_search(text, found, compiled_->expression)) return std::nullopt;
  return Groups(found.begin(), found.end());
}

}  // namespace lt
