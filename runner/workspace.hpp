/// @file
/// The learner's files: my/02.2-sphere.cpp, the starter it was made from, and what was saved.
#pragma once

#include <filesystem>
#include <string>

#include "runner/exercise.hpp"

namespace lt {

/// What happened when an exercise was opened.
enum class Opened {
  as_it_was,
  created,          ///< the learner's file was made from the starter
  updated,          ///< the starter had changed and the learner had not: the new one is there
  starter_changed,  ///< both have changed: a merge can be offered
};

/// What became of a three-way merge.
enum class Merged {
  cleanly,   ///< the learner's file now has both changes; the old one is saved
  conflict,  ///< both changed the same lines: nothing was touched
  no_git,    ///< git is not there: nothing was touched
};

/// The folder my/. No file that the learner wrote is ever overwritten without a copy in my/.saved.
class Workspace {
 public:
  explicit Workspace(std::filesystem::path my) : my_(std::move(my)) {}

  [[nodiscard]] std::filesystem::path answer(const Exercise& exercise) const;
  [[nodiscard]] bool has_answer(const Exercise& exercise) const;
  /// True if the learner has changed nothing yet.
  [[nodiscard]] bool is_untouched(const Exercise& exercise) const;

  /// Makes sure that the learner's file is there; see Opened.
  /// @param build_folder  for the hint that tells clangd where the compiler's flags are
  Opened open(const Exercise& exercise, const std::filesystem::path& build_folder) const;

  /// Merges the changes of the starter into the learner's file (git merge-file).
  Merged merge(const Exercise& exercise) const;

  /// Puts the starter back.
  /// @return where the old file is now
  std::filesystem::path reset(const Exercise& exercise) const;

 private:
  [[nodiscard]] std::filesystem::path base(const Exercise& exercise) const;
  std::filesystem::path save(const Exercise& exercise) const;

  std::filesystem::path my_;
};

}  // namespace lt
