#include "runner/watch.hpp"

#include <chrono>
#include <iostream>

#include "common/files.hpp"
#include "runner/build.hpp"
#include "runner/opening.hpp"
#include "runner/screen.hpp"
#include "runner/terminal.hpp"
#include "runner/text.hpp"

namespace lt {

bool Watcher::has_changed(const Lesson& lesson, const Exercise& exercise) {
  const std::string answer = lesson.answer_fingerprint(exercise);
  const std::string test = lesson.test_fingerprint(exercise);
  const std::string now = exercise.id + " " + answer + " " + test;
  // Gone: an editor is renaming it, or git is bringing a new one.
  if (answer.empty() || test.empty() || now == seen_) return false;
  seen_ = now;
  return true;
}

namespace {

// The watch's screen and what its keys do.
class Watch {
 public:
  explicit Watch(const Lesson& lesson) : lesson_(lesson) {}

  int run() {
    open(lesson_.current());
    while (true) {
      follow_other_commands();
      if (watcher_.has_changed(lesson_, *exercise_)) check();
      const int columns = terminal_columns();
      const char key = keys_.key(Watcher::interval);
      if (key == 'q' || key == KeyReader::closed) break;
      if (key == KeyReader::resumed || columns != terminal_columns()) draw();
      if (key > ' ') press(key);
    }
    std::cout << "\nUntil next time: ./learn goes on with " << exercise_->id << ".\n";
    return 0;
  }

 private:
  void open(const Exercise& exercise) {
    exercise_ = &exercise;
    verdict_.reset();
    lesson_.set_current(exercise);
    const Opening opening = open_exercise(lesson_, exercise);
    note_ = opening.note;
    if (opening.can_merge) offer_merge();
    watcher_ = Watcher();
    last_there_ = std::chrono::steady_clock::now();
  }

  // `./learn next` or `run` in another terminal moves this one too.
  void follow_other_commands() {
    if (is_answer_gone()) return open(*exercise_);
    const Exercise& current = lesson_.current();
    if (current.id != exercise_->id && lesson_.progress().load().current == current.id) {
      open(current);
    }
  }

  // Some editors move a file away before they write the new one: a moment without it means nothing.
  [[nodiscard]] bool is_answer_gone() {
    constexpr std::chrono::seconds moment(2);
    const auto now = std::chrono::steady_clock::now();
    if (lesson_.workspace().has_answer(*exercise_)) last_there_ = now;
    return now - last_there_ > moment;
  }

  void check() {
    if (!verdict_) draw();  // the first build takes a moment: show what it is for
    try {
      verdict_ = lesson_.check(*exercise_);
      build_failure_.clear();
    } catch (const BuildFailed& failure) {
      verdict_.reset();
      build_failure_ = failure.what();
    }
    draw();
    note_.clear();
  }

  void draw() const {
    clear_screen();
    const int all = static_cast<int>(lesson_.exercises().size());
    std::cout << card(lesson_, *exercise_) << '\n';
    if (!note_.empty()) std::cout << wrapped(note_, terminal_columns(), 2) << '\n';
    if (verdict_) std::cout << verdict_text(lesson_, *exercise_, *verdict_, Mode::keys);
    if (!build_failure_.empty()) {
      std::cout << ink::red("The build failed, and not in your file:") << '\n' << build_failure_;
    }
    const int hints = lesson_.record(*exercise_).hints;
    if (hints > 0) std::cout << '\n' << hints_text(*exercise_, hints, Mode::keys);
    std::cout << '\n'
              << progress_bar(lesson_.done_count(), all) << '\n'
              << keys_line() << std::flush;
  }

  void say(const std::string& text) {
    note_ = text;
    draw();
    note_.clear();
  }

  void press(char key) {
    switch (key) {
      case 'n':
        return next();
      case 'h':
        lesson_.change_record(*exercise_, [](Record& record) {
          if (record.hints < 3) ++record.hints;
        });
        return draw();
      case 's':
        return show_solution();
      case 'l':
        return show_page(list_text(lesson_));
      case 'r':
        return reset();
      default:
        return;
    }
  }

  void next() {
    const Exercise* next = lesson_.next_after(*exercise_);
    if (next == nullptr) {
      return say(lesson_.state(*exercise_) == State::done
                     ? "Every exercise is done. l lists them."
                     : "Every other exercise is done: this is the last one.");
    }
    open(*next);
  }

  void show_solution() {
    if (!lesson_.record(*exercise_).is_done) {
      return say(
          "The solution opens when your answer is done. If you are stuck: h shows a hint, "
          "and ./learn solution " +
          exercise_->id + " --anyway shows it all the same.");
    }
    const auto file = exercise_->folder / "solution.cpp";
    show_page(ink::dim(shown_path(file)) + "\n\n" + read_file(file));
  }

  void show_page(const std::string& text) {
    clear_screen();
    std::cout << text << '\n' << ink::dim("any key goes back") << std::flush;
    while (keys_.key(std::chrono::seconds(1)) == 0) {
    }
    draw();
  }

  [[nodiscard]] bool ask(const std::string& question) {
    std::cout << '\n' << ink::yellow(question) << " y/n " << std::flush;
    while (true) {
      const char key = keys_.key(std::chrono::seconds(1));
      if (key == 'y') return true;
      if (key == 'n' || key == 'q' || key == KeyReader::closed || key == 27) return false;
    }
  }

  void reset() {
    if (!ask("Put the starter back? Your file is saved first.")) return draw();
    const auto saved = reset_exercise(lesson_, *exercise_);
    note_ = "Your old file is " + shown_path(saved) + ".";
    watcher_ = Watcher();
  }

  void offer_merge() {
    clear_screen();
    std::cout << card(lesson_, *exercise_) << '\n' << wrapped(note_, terminal_columns(), 2);
    note_ = ask("Merge the new starter into your file?") ? merge_exercise(lesson_, *exercise_)
                                                         : decline_merge(lesson_, *exercise_);
  }

  const Lesson& lesson_;
  const Exercise* exercise_ = nullptr;
  std::optional<Verdict> verdict_;
  std::string build_failure_;
  std::string note_;                                  // shown once
  std::chrono::steady_clock::time_point last_there_;  // the learner's file, when last looked
  Watcher watcher_;
  KeyReader keys_;
};

}  // namespace

int watch(const Lesson& lesson) {
  return Watch(lesson).run();
}

}  // namespace lt
