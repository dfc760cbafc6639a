// How long does a learner wait? Scripted edits through the watch's own path: a file is written at
// any moment between two looks, the watch sees it, builds it, runs it and has its verdict.
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <random>
#include <thread>

#include "common/error.hpp"
#include "common/files.hpp"
#include "runner/commands.hpp"
#include "runner/lesson.hpp"
#include "runner/text.hpp"
#include "runner/watch.hpp"

namespace lt {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

// An edit that a learner might make, and the state it must lead to.
struct Edit {
  const Exercise* exercise;
  std::string what;
  std::string text;
  State leads_to;
};

std::string replaced_once(std::string text, const std::string& find, const std::string& with) {
  const std::size_t place = text.find(find);
  return place == std::string::npos ? text : text.replace(place, find.size(), with);
}

// Round i over all exercises: a right answer, a mistake, a typing error, another right answer.
Edit scripted_edit(const std::vector<Exercise>& exercises, int i) {
  const int count = static_cast<int>(exercises.size());
  const Exercise& exercise = exercises[static_cast<std::size_t>(i % count)];
  const std::string solution = read_file(exercise.folder / "solution.cpp");
  const std::string remark = "\n// edit " + std::to_string(i) + "\n";
  const Mutant& mutant = exercise.mutants[static_cast<std::size_t>(i) % exercise.mutants.size()];
  switch ((i + i / count) % 4) {
    case 0:
      return {&exercise, "right", solution + remark, State::done};
    case 1:
      return {&exercise, "mistake " + mutant.tag,
              replaced_once(solution, mutant.find, mutant.replace) + remark, State::not_yet};
    case 2:
      return {&exercise, "does not compile", solution + remark + "int missing = ;\n",
              State::not_yet};
    default:
      return {&exercise, "right, otherwise", read_file(exercise.folder / "other.cpp") + remark,
              State::done};
  }
}

// Seconds from the moment in which the file was written to the verdict.
double time_edit(const Lesson& lesson, const Edit& edit, Watcher& watcher, double phase) {
  const fs::path answer = lesson.workspace().answer(*edit.exercise);
  Clock::time_point written;
  std::thread editor([&] {
    std::this_thread::sleep_for(Watcher::interval * phase);
    write_file_whole(answer, edit.text);
    written = Clock::now();
  });
  while (!watcher.has_changed(lesson, *edit.exercise)) {
    std::this_thread::sleep_for(Watcher::interval);
  }
  editor.join();
  (void)lesson.check(*edit.exercise);
  return std::chrono::duration<double>(Clock::now() - written).count();
}

double percentile(const std::vector<double>& sorted, double share) {
  const double rank = std::ceil(share * static_cast<double>(sorted.size()));
  return sorted[static_cast<std::size_t>(std::max(1.0, rank)) - 1];
}

class TemporaryFolder {
 public:
  TemporaryFolder()
      : path_(fs::temp_directory_path() / ("lt-edits-" + std::to_string(std::random_device{}()))) {
    fs::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

int measure_edits_command(const Home& home, Arguments& arguments) {
  const int count = arguments.number("--count", 20, 1, 10'000);
  arguments.nothing_more();
  const TemporaryFolder folder;
  Home elsewhere = home;
  elsewhere.my = folder.path();
  elsewhere.workspace = folder.path() / ".build";
  const Lesson lesson(elsewhere);

  std::cout << "opening " << lesson.exercises().size() << " exercises (not measured) ..."
            << std::endl;
  std::vector<Watcher> watchers(lesson.exercises().size());
  for (std::size_t i = 0; i < watchers.size(); ++i) {
    const Exercise& exercise = lesson.exercises()[i];
    lesson.workspace().open(exercise, elsewhere.workspace);
    (void)lesson.check(exercise);
    (void)watchers[i].has_changed(lesson, exercise);
  }

  std::mt19937 random(1);
  std::uniform_real_distribution<double> phase(0, 1);
  std::vector<double> times;
  int wrong = 0;
  for (int i = 0; i < count; ++i) {
    const Edit edit = scripted_edit(lesson.exercises(), i);
    Watcher& watcher = watchers[static_cast<std::size_t>(i) % watchers.size()];
    times.push_back(time_edit(lesson, edit, watcher, phase(random)));
    const State state = lesson.state(*edit.exercise);
    if (state != edit.leads_to) ++wrong;
    std::printf("%4.2f s  %s %s: %s: %s%s\n", times.back(), edit.exercise->id.c_str(),
                edit.exercise->name.c_str(), edit.what.c_str(), in_words(state).c_str(),
                state == edit.leads_to ? "" : " - UNEXPECTED");
    std::fflush(stdout);
  }
  std::sort(times.begin(), times.end());
  const double p95 = percentile(times, 0.95);
  std::printf("edit to verdict over %d edits: p50 %.2f s, p95 %.2f s, max %.2f s\n", count,
              percentile(times, 0.5), p95, times.back());
  if (wrong > 0) std::printf("%d edits did not get the verdict they should\n", wrong);
  return p95 < 2 && wrong == 0 ? 0 : 1;
}

}  // namespace lt
