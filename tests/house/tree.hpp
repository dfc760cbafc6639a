/// @file
/// The repository as the checks see it.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace lt::house {

/// The files that belong to a project, by their names from its root ("common/files.hpp").
class Tree {
 public:
  /// @param root  a folder. Where it is a git work tree, what git ignores does not belong to it;
  ///              elsewhere build/, out/, my/ and node_modules/ do not.
  explicit Tree(std::filesystem::path root);

  [[nodiscard]] const std::filesystem::path& root() const { return root_; }
  /// Sorted names, forward slashes.
  [[nodiscard]] const std::vector<std::string>& files() const { return files_; }
  /// The files below a folder, e.g. files_in("common/", ".hpp").
  [[nodiscard]] std::vector<std::string> files_in(std::string_view folder,
                                                  std::string_view ending = "") const;
  /// Names of the folders directly in `folder` (with its slash) that hold a file of the project.
  [[nodiscard]] std::vector<std::string> folders_in(std::string_view folder) const;
  [[nodiscard]] bool has_file(const std::string& name) const { return names_.contains(name); }
  [[nodiscard]] bool has_folder(const std::string& name) const;

  [[nodiscard]] std::string text(const std::string& name) const;
  /// Lines without their ends; line n is at n - 1.
  [[nodiscard]] std::vector<std::string> lines(const std::string& name) const;

 private:
  std::filesystem::path root_;
  std::vector<std::string> files_;
  std::set<std::string> names_;
};

/// True for files that people read as text, judged by their names.
[[nodiscard]] bool is_text(std::string_view name);

/// True for .hpp and .cpp.
[[nodiscard]] bool is_cpp(std::string_view name);

/// "ch02_ray_casting" of "chapters/ch02_ray_casting/sphere.hpp": the part after the first folder.
[[nodiscard]] std::string second_part(std::string_view name);

/// The number of a chapter's folder: 2 for "ch02_ray_casting", 0 for what is no chapter.
[[nodiscard]] int chapter_number(const std::string& chapter);

}  // namespace lt::house
