/// @file
/// Where things are: the repository, the learner's files, the build folders.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lt {

/// The folders that the runner works in. Each can be moved by an environment variable, which is
/// how the tests keep out of the learner's way.
struct Home {
  std::filesystem::path root;       ///< the repository (LT_HOME)
  std::filesystem::path my;         ///< the learner's files (LT_MY), root/my
  std::filesystem::path exercises;  ///< folders with exercise.json, two levels down (LT_EXERCISES)
  std::filesystem::path workspace;  ///< where the learner's programs are built
  std::filesystem::path out;        ///< pictures (LT_OUT), root/out

  /// The build folder of a preset: root/build/NAME.
  [[nodiscard]] std::filesystem::path build(const std::string& preset = "release") const {
    return root / "build" / preset;
  }
};

/// The folders as the environment says, else as compiled in.
/// @throws InputError  LT_HOME is no folder of this course
[[nodiscard]] Home find_home();

/// The path as a person in the current folder would type it: relative where that is shorter.
[[nodiscard]] std::string shown_path(const std::filesystem::path& path);

/// The folders chapters/chNN_name, in order.
[[nodiscard]] std::vector<std::string> chapter_names(const Home& home);

/// The chapter that the person means by "2", "02", "ch02" or "ch02_ray_casting".
/// @throws InputError  there is none
[[nodiscard]] std::string find_chapter(const Home& home, const std::string& word);

}  // namespace lt
