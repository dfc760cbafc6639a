#include "runner/workspace.hpp"

#include "common/error.hpp"
#include "common/files.hpp"
#include "runner/process.hpp"

namespace lt {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t largest_source = 10'000'000;

std::string starter_of(const Exercise& exercise) {
  return read_file(exercise.folder / "starter.cpp", largest_source);
}

// clangd completes code in my/ when it knows the compiler's flags.
void write_clangd_file(const fs::path& my, const fs::path& build_folder) {
  const fs::path file = my / ".clangd";
  if (fs::exists(file)) return;
  write_file_whole(file, "CompileFlags:\n  CompilationDatabase: " +
                             build_folder.lexically_proximate(my).generic_string() + "\n");
}

}  // namespace

fs::path Workspace::answer(const Exercise& exercise) const {
  return my_ / exercise.file_name();
}

fs::path Workspace::base(const Exercise& exercise) const {
  return my_ / ".base" / exercise.file_name();
}

bool Workspace::has_answer(const Exercise& exercise) const {
  return fs::exists(answer(exercise));
}

bool Workspace::is_untouched(const Exercise& exercise) const {
  if (!has_answer(exercise)) return true;
  const std::string text = read_file(answer(exercise), largest_source);
  return text == starter_of(exercise) ||
         (fs::exists(base(exercise)) && text == read_file(base(exercise), largest_source));
}

Opened Workspace::open(const Exercise& exercise, const fs::path& build_folder) const {
  const std::string starter = starter_of(exercise);
  if (!has_answer(exercise)) {
    write_file_whole(base(exercise), starter);
    write_file_whole(answer(exercise), starter);
    write_clangd_file(my_, build_folder);
    return Opened::created;
  }
  // Without its base a file cannot be merged: take the starter of today for it.
  if (!fs::exists(base(exercise))) write_file_whole(base(exercise), starter);
  const std::string old_starter = read_file(base(exercise), largest_source);
  if (old_starter == starter) return Opened::as_it_was;

  const std::string text = read_file(answer(exercise), largest_source);
  if (text != old_starter && text != starter) return Opened::starter_changed;
  write_file_whole(answer(exercise), starter);
  write_file_whole(base(exercise), starter);
  return Opened::updated;
}

Merged Workspace::merge(const Exercise& exercise) const {
  const ProcessResult result =
      run_process({"git", "merge-file", "-q", "-p", answer(exercise).string(),
                   base(exercise).string(), (exercise.folder / "starter.cpp").string()});
  if (result.exit_code == 127) return Merged::no_git;
  if (!result.succeeded()) return Merged::conflict;
  save(exercise);
  write_file_whole(answer(exercise), result.output);
  write_file_whole(base(exercise), starter_of(exercise));
  return Merged::cleanly;
}

fs::path Workspace::reset(const Exercise& exercise) const {
  const fs::path saved = save(exercise);
  write_file_whole(base(exercise), starter_of(exercise));
  write_file_whole(answer(exercise), starter_of(exercise));
  return saved;
}

fs::path Workspace::save(const Exercise& exercise) const {
  if (!has_answer(exercise)) throw InputError(exercise.file_name() + " has not been opened yet");
  const fs::path stem = my_ / ".saved" / (exercise.id + "-" + exercise.name);
  for (int number = 1;; ++number) {
    fs::path file = stem;
    file += "." + std::to_string(number) + ".cpp";
    if (fs::exists(file)) continue;
    write_file_whole(file, read_file(answer(exercise), largest_source));
    return file;
  }
}

}  // namespace lt
