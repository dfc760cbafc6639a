/// @file
/// Text and code are one: fences of a README that are cut from the compiled files.
///
/// In a source file a region lies between two lines `// [tag]`. In a README a line
/// `<!-- snippet: sphere.hpp closest-root -->` stands directly above the fence that shows it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runner/home.hpp"

namespace lt {

/// Something about a snippet that is not as it must be.
struct SnippetProblem {
  int line = 0;  ///< in the README, from 1
  std::string what;
};

/// A README with its fences as the files are now.
struct FreshText {
  std::string text;
  std::vector<SnippetProblem> drifted;  ///< fences that were different
  std::vector<SnippetProblem> broken;   ///< what cannot be refreshed: no such file, tag or fence
};

/// The lines between the two `// [tag]` of a source, dedented, without tag lines.
/// @return nothing unless the tag is there exactly twice
[[nodiscard]] std::optional<std::string> snippet(std::string_view source, std::string_view tag);

/// @param read_source  the text of the file that a comment names, or nothing if there is none
[[nodiscard]] FreshText with_fresh_snippets(
    std::string_view readme,
    const std::function<std::optional<std::string>(const std::string&)>& read_source);

/// The same for the README of a chapter. Names that begin with common/ or chapters/ count from the
/// repository's root, all others from the chapter's folder.
/// @throws InputError  the README is missing
[[nodiscard]] FreshText chapter_with_fresh_snippets(const Home& home, const std::string& chapter);

}  // namespace lt
