/// @file
/// Small projects in temporary folders, in which a test puts one thing out of place.
#pragma once

#include <string>

#include "tests/house/process.hpp"
#include "tests/house/tree.hpp"

namespace lt::house {

/// A project that exists for one test.
class PlantedProject {
 public:
  /// Writes a file; `name` is from the project's root.
  void write(const std::string& name, const std::string& text);
  /// Replaces text that occurs in a file; fails the test where it does not.
  void replace(const std::string& name, const std::string& find, const std::string& by);
  void remove(const std::string& name);
  /// Opens it for a check, as it is now.
  [[nodiscard]] Tree tree() const { return Tree(folder_.path()); }

 private:
  TemporaryFolder folder_;
};

/// Fills an empty project with two complete chapters, ch01_dots and ch02_lines (which stands on
/// it), an exercise for each, and the tables of contents: no check finds anything.
void plant_complete_project(PlantedProject& project);

}  // namespace lt::house
