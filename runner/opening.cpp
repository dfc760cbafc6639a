#include "runner/opening.hpp"

#include "common/files.hpp"
#include "runner/text.hpp"

namespace lt {

namespace {

std::string starter_fingerprint(const Exercise& exercise) {
  return fingerprint(read_file(exercise.folder / "starter.cpp"));
}

}  // namespace

Opening open_exercise(const Lesson& lesson, const Exercise& exercise) {
  switch (lesson.workspace().open(exercise, lesson.home().workspace)) {
    case Opened::created:
      return {"Your file has been made from the starter."};
    case Opened::updated:
      return {"The starter has been improved since; your file was untouched and is the new one."};
    case Opened::starter_changed:
      if (lesson.record(exercise).kept == starter_fingerprint(exercise)) return {};
      return {"The starter has changed since you began, and so has your file.", true};
    case Opened::as_it_was:
      break;
  }
  return {};
}

std::string merge_exercise(const Lesson& lesson, const Exercise& exercise) {
  switch (lesson.workspace().merge(exercise)) {
    case Merged::cleanly:
      return "Merged. Your file as it was is in " + shown_path(lesson.home().my / ".saved") + ".";
    case Merged::conflict:
      decline_merge(lesson, exercise);
      return "Both changed the same lines, so your file stays as it is. Compare it with " +
             shown_path(exercise.folder / "starter.cpp") + ".";
    case Merged::no_git:
      return "A merge needs git, which is not installed. Your file stays as it is.";
  }
  return "";
}

std::string decline_merge(const Lesson& lesson, const Exercise& exercise) {
  lesson.change_record(exercise,
                       [&](Record& record) { record.kept = starter_fingerprint(exercise); });
  return "Your file stays as it is. ./learn run " + exercise.id + " --merge merges later.";
}

std::filesystem::path reset_exercise(const Lesson& lesson, const Exercise& exercise) {
  const std::filesystem::path saved = lesson.workspace().reset(exercise);
  lesson.change_record(exercise, [](Record& record) { record = Record{}; });
  return saved;
}

}  // namespace lt
