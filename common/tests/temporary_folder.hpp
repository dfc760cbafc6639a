// A folder that goes away with its test, and what a call complains about.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "common/error.hpp"

namespace lt::test {

/// A new folder that everyone may enter (tests also act as another user), removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::random_device random;
    path_ = std::filesystem::temp_directory_path() / ("lt_test_" + std::to_string(random()));
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
    return path_ / name;
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// Names of all that is in it, sorted: nothing else may have been left behind.
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(path_))
      all.push_back(entry.path().filename().string());
    std::sort(all.begin(), all.end());
    return all;
  }

 private:
  std::filesystem::path path_;
};

/// Writes bytes without the code under test. (Some file systems wait for the disk when a file is
/// overwritten, none when it is new.)
inline std::filesystem::path put(const std::filesystem::path& path, const std::string& bytes) {
  std::filesystem::remove(path);
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

/// Reads bytes without the code under test.
inline std::string get(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// What a call says when it throws such an error; "(no error)" if it does not.
template <class Error, class Call>
std::string message_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "(no error)";
}

template <class Call>
std::string input_error(const Call& call) {
  return message_of<InputError>(call);
}

template <class Call>
std::string output_error(const Call& call) {
  return message_of<OutputError>(call);
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

/// One line that names `thing` and, after a semicolon, the remedy.
inline bool is_one_line_with_remedy(const std::string& message, const std::string& thing) {
  return contains(message, thing) && contains(message, "; ") && !contains(message, "\n");
}

}  // namespace lt::test
