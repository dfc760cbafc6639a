#include "runner/home.hpp"

#include <algorithm>
#include <cstdlib>

#include "common/error.hpp"
#include "runner/text.hpp"

namespace lt {

namespace fs = std::filesystem;

namespace {

fs::path from_environment(const char* name, const fs::path& otherwise) {
  const char* value = std::getenv(name);
  return value == nullptr || *value == '\0' ? otherwise : fs::absolute(value).lexically_normal();
}

}  // namespace

Home find_home() {
  Home home;
  home.root = from_environment("LT_HOME", LT_DEFAULT_HOME);
  if (!fs::is_regular_file(home.root / "cmake" / "lt.cmake")) {
    throw InputError(home.root.string() + " is not the course's folder: set LT_HOME to it");
  }
  const fs::path default_my = home.root / "my";
  const fs::path default_exercises = home.root / "exercises";
  home.my = from_environment("LT_MY", default_my);
  home.exercises = from_environment("LT_EXERCISES", default_exercises);
  const bool is_default = home.my == default_my && home.exercises == default_exercises;
  home.workspace = is_default ? home.build("exercises") : home.my / ".build";
  home.out = from_environment("LT_OUT", home.root / "out");
  return home;
}

std::string shown_path(const fs::path& path) {
  std::error_code error;
  const std::string relative = fs::proximate(path, error).generic_string();
  if (error || relative.empty() || relative.starts_with("../..")) return path.generic_string();
  return relative;
}

std::vector<std::string> chapter_names(const Home& home) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(home.root / "chapters", error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("ch") && entry.is_directory()) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string find_chapter(const Home& home, const std::string& word) {
  const std::vector<std::string> names = chapter_names(home);
  std::string number = word.starts_with("ch") ? word.substr(2) : word;
  if (number.size() == 1) number.insert(0, "0");
  for (const std::string& name : names) {
    if (name == word || (number.size() == 2 && name.starts_with("ch" + number + "_"))) return name;
  }
  std::vector<std::string> numbers;
  for (const std::string& name : names)
    numbers.push_back(std::to_string(std::stoi(name.substr(2))));
  throw InputError("no chapter " + word +
                   did_you_mean(word, names, "there are chapters " + join(numbers, ", ")));
}

}  // namespace lt
