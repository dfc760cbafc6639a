/// @file
/// A learner's folder and a course of one exercise, 00.1 halve, that a test may change.
#pragma once

#include <filesystem>
#include <string>

#include "common/files.hpp"
#include "common/tests/temporary_folder.hpp"
#include "runner/lesson.hpp"

namespace lt::test {

/// Both are copies in a folder of their own.
class ToyCourse {
 public:
  ToyCourse() {
    const std::filesystem::path root = LT_ROOT;
    std::filesystem::copy(root / "runner" / "tests" / "data" / "exercises", folder_ / "exercises",
                          std::filesystem::copy_options::recursive);
  }

  [[nodiscard]] Home home() const {
    Home home;
    home.root = LT_ROOT;
    home.my = my();
    home.exercises = folder_ / "exercises";
    home.workspace = my() / ".build";
    return home;
  }
  [[nodiscard]] std::filesystem::path my() const { return folder_ / "my"; }
  /// A file of the exercise's folder.
  [[nodiscard]] std::filesystem::path file(const std::string& name) const {
    return folder_ / "exercises" / "ch00_toy" / "halve" / name;
  }
  [[nodiscard]] std::filesystem::path answer() const { return my() / "00.1-halve.cpp"; }

  /// Replaces the first `find` in a file.
  static void replace(const std::filesystem::path& path, const std::string& find,
                      const std::string& by) {
    std::string text = read_file(path);
    write_file_whole(path, text.replace(text.find(find), find.size(), by));
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace lt::test
