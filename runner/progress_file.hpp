/// @file
/// my/progress.json: what the runner remembers between two calls. A cache, never the truth.
#pragma once

#include <filesystem>
#include <functional>

#include "runner/json_files.hpp"

namespace lt {

/// Reads and changes the file. Several runners may be at work (a watch here, a `hint` there): each
/// change reads the file anew.
class ProgressFile {
 public:
  explicit ProgressFile(std::filesystem::path path) : path_(std::move(path)) {}

  /// What the file says; nothing remembered if it is missing or broken.
  /// @throws InputError  it cannot be read at all: a folder, no permission
  [[nodiscard]] LearnerProgress load() const;

  /// True if the file is there and is no progress file.
  [[nodiscard]] bool is_broken() const;

  /// Reads, changes and writes the file.
  /// @throws OutputError  it cannot be written
  void change(const std::function<void(LearnerProgress&)>& edit) const;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  [[nodiscard]] std::string text() const;

  std::filesystem::path path_;
};

}  // namespace lt
