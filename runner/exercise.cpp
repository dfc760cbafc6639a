#include "runner/exercise.hpp"

#include <algorithm>
#include <cctype>

#include "common/error.hpp"
#include "common/files.hpp"
#include "runner/json_files.hpp"
#include "runner/text.hpp"

namespace lt {

namespace fs = std::filesystem;

const Mutant* Exercise::mutant(std::string_view tag) const {
  const auto found = std::find_if(mutants.begin(), mutants.end(),
                                  [&](const Mutant& mutant) { return mutant.tag == tag; });
  return found == mutants.end() ? nullptr : &*found;
}

namespace {

std::vector<fs::path> description_files(const fs::path& exercises) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const auto& chapter : fs::directory_iterator(exercises, ignored)) {
    if (!chapter.is_directory()) continue;
    for (const auto& folder : fs::directory_iterator(chapter.path(), ignored)) {
      const fs::path file = folder.path() / "exercise.json";
      if (fs::exists(file, ignored)) files.push_back(file);
    }
  }
  return files;
}

// A file that was deleted by mistake, or a checkout that was cut short.
void check_files(const Exercise& exercise) {
  for (const char* name : {"api.hpp", "starter.cpp", "test.cpp", "solution.cpp", "README.md"}) {
    const std::string file = shown_path(exercise.folder / name);
    std::error_code ignored;
    if (!fs::is_regular_file(exercise.folder / name, ignored)) {
      throw InputError(file + " is missing; git checkout -- " + file + " brings it back");
    }
  }
}

}  // namespace

std::vector<Exercise> load_exercises(const Home& home) {
  std::vector<Exercise> exercises;
  for (const fs::path& file : description_files(home.exercises)) {
    exercises.push_back(parse_exercise(read_file(file, 1 << 20), file));
    check_files(exercises.back());
  }
  std::sort(exercises.begin(), exercises.end(),
            [](const Exercise& a, const Exercise& b) { return a.id < b.id; });
  const auto twice =
      std::adjacent_find(exercises.begin(), exercises.end(),
                         [](const Exercise& a, const Exercise& b) { return a.id == b.id; });
  if (twice != exercises.end()) {
    throw InputError("exercise " + twice->id + " is there twice: " + shown_path(twice->folder) +
                     " and " + shown_path((twice + 1)->folder));
  }
  return exercises;
}

const Exercise& find_exercise(const std::vector<Exercise>& exercises, const std::string& word) {
  std::string wanted = word;
  if (wanted.size() >= 2 && std::isdigit(static_cast<unsigned char>(wanted[0])) != 0 &&
      wanted[1] == '.') {
    wanted.insert(0, "0");
  }
  std::vector<std::string> choices;
  for (const Exercise& exercise : exercises) {
    const std::string both = exercise.id + "-" + exercise.name;
    if (wanted == exercise.id || wanted == exercise.name || wanted == both) return exercise;
    choices.push_back(exercise.id);
    choices.push_back(exercise.name);
  }
  if (choices.empty()) throw InputError("there are no exercises yet");
  throw InputError("no exercise " + printable(word) +
                   did_you_mean(wanted, choices, "./learn list shows them all"));
}

}  // namespace lt
