/// @file
/// Everything that is read or written as JSON. The JSON library stays in json_files.cpp: it is slow
/// to compile.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runner/exercise.hpp"

namespace lt {

/// @param file  where the text is from: its folders must agree with name and chapter
/// @throws InputError  not JSON, a key is missing, unknown or of the wrong kind; one line that
///                     names the file, the key and what it takes
[[nodiscard]] Exercise parse_exercise(std::string_view text, const std::filesystem::path& file);

/// What is remembered of one exercise.
struct Record {
  bool is_done = false;
  std::string answer;  ///< fingerprint of the learner's file when it was last checked
  std::string test;    ///< fingerprint of the test that checked it
  std::string kept;    ///< fingerprint of a newer starter that the learner declined to merge
  int hints = 0;       ///< how many have been shown, 0 to 3
};

/// What my/progress.json holds. A cache only: `./learn verify` makes it anew.
struct LearnerProgress {
  std::string current;  ///< id of the exercise that is open, or empty
  std::map<std::string, Record> records;
};

/// @return nothing if the text is no progress file, whatever else it is
[[nodiscard]] std::optional<LearnerProgress> parse_progress(std::string_view text);
[[nodiscard]] std::string to_json(const LearnerProgress& progress);

/// The size of a picture in pixels.
struct PictureSize {
  int width = 0;
  int height = 0;
};

/// One picture that a chapter's program makes.
struct Picture {
  std::string chapter;
  std::string file;
  std::string title;  ///< may be empty
  std::string caption;
  std::vector<std::string> args;
  PictureSize full{900, 720};
  bool is_stored = false;             ///< the texts show it from chapters/CHAPTER/figures
  std::optional<PictureSize> stored;  ///< its size there, if it is made of pixels
};

/// The entries of a chapter's pictures.json.
/// @throws InputError  as parse_exercise
[[nodiscard]] std::vector<Picture> parse_pictures(std::string_view text, const std::string& chapter,
                                                  const std::filesystem::path& file);

}  // namespace lt
