/// @file
/// Options that change something only beside certain others. Part of the command line.
#pragma once

#include <string>
#include <vector>

namespace lt {

/// `name` is used only where `other` has one of `choices`; where these are empty, only where
/// `other` is given at all.
struct OptionUse {
  std::string name;
  std::string other;
  std::vector<std::string> choices;
};

/// For an option that was given, beside the others.
/// @param other_given  whether `use.other` was given, too
/// @param chosen       the value of `use.other`, given or not
/// @throws InputError  the option would change nothing
void require_use(const OptionUse& use, bool other_given, const std::string& chosen);

}  // namespace lt
