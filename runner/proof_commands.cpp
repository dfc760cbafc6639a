// What CI proves of the exercises: `judge` (one program, for CTest) and `verify --all` (a table).
#include <iostream>

#include "common/error.hpp"
#include "common/files.hpp"
#include "runner/build.hpp"
#include "runner/commands.hpp"
#include "runner/json_files.hpp"
#include "runner/judge.hpp"
#include "runner/proof.hpp"
#include "runner/terminal.hpp"
#include "runner/text.hpp"

namespace lt {

namespace fs = std::filesystem;

namespace {

RunLimits limits_for(int seeds) {
  RunLimits limits;
  limits.seeds = seeds;
  limits.seconds = seeds > 1 ? 100 : 20;
  return limits;
}

std::string judged(const Exercise& exercise, const fs::path& program, const Answer& answer) {
  return complaint(answer.kind, run_answer(exercise, program, limits_for(answer.seeds)));
}

// The cell of the table: which column an answer belongs to.
int column_of(const Answer& answer) {
  if (answer.seeds > 1) return 4;
  if (answer.kind == "solution") return 0;
  if (answer.kind == "other") return 1;
  return answer.kind == "starter" ? 2 : 3;
}

void print_row(const Exercise& exercise, const std::vector<int>& passed,
               const std::vector<int>& judged_count) {
  std::cout << padded(exercise.id + " " + exercise.name, 28);
  for (std::size_t i = 0; i < passed.size(); ++i) {
    const std::string share = std::to_string(passed[i]) + "/" + std::to_string(judged_count[i]);
    const std::string cell = padded(judged_count[i] == 0 ? "-" : share, 10);
    std::cout << (judged_count[i] == 0           ? ink::dim(cell)
                  : passed[i] == judged_count[i] ? ink::green(cell)
                                                 : ink::red(cell));
  }
  std::cout << std::endl;
}

}  // namespace

int judge_command(const Home& home, Arguments& arguments) {
  const int seeds = arguments.number("--seeds", 1, 1, 10'000'000);
  const std::vector<std::string> words = arguments.words(3);
  if (words.empty()) {
    const std::size_t count = load_exercises(home).size();
    std::cout << count << " exercise.json files are complete" << std::endl;
    return 0;
  }
  if (words.size() != 3) throw InputError("judge takes a folder, an answer and a program");
  const fs::path file = fs::path(words[0]) / "exercise.json";
  const Exercise exercise = parse_exercise(read_file(file), file);
  const Answer answer{words[1], seeds};
  const AnswerRun run = run_answer(exercise, words[2], limits_for(seeds));
  const std::string wrong = complaint(answer.kind, run);
  if (!wrong.empty()) std::cout << run.result.output;
  std::cout << sentence_of(exercise, answer) << ": " << (wrong.empty() ? "yes" : wrong)
            << std::endl;
  return wrong.empty() ? 0 : 1;
}

int prove(const Home& home, const ProofChoice& choice) {
  const std::vector<Exercise> exercises = load_exercises(home);
  configure(home, "release");
  build(home.build(), {"exercise_programs"}, "building every answer of every exercise");

  std::cout << padded("exercise", 28);
  for (const char* head : {"solution", "other", "starter", "mutants", "fair"}) {
    std::cout << padded(head, 10);
  }
  std::cout << std::endl;
  int passed = 0;
  std::vector<std::string> complaints;
  for (const Exercise& exercise : exercises) {
    std::vector<int> good(5), all(5);
    for (const Answer& answer : choice.answers(exercise)) {
      const fs::path program =
          built_program(home.build() / "exercises", "ex_" + exercise.id + "_" + answer.kind);
      const std::string wrong = judged(exercise, program, answer);
      const auto column = static_cast<std::size_t>(column_of(answer));
      ++all[column];
      good[column] += wrong.empty() ? 1 : 0;
      passed += wrong.empty() ? 1 : 0;
      if (!wrong.empty()) complaints.push_back(sentence_of(exercise, answer) + ": no, " + wrong);
    }
    print_row(exercise, good, all);
  }
  for (const std::string& line : complaints)
    std::cout << ink::red("failed ") << line << '\n';
  std::cout << passed << " passed, " << complaints.size() << " failed" << std::endl;
  return complaints.empty() ? 0 : 1;
}

std::vector<Answer> ProofChoice::answers(const Exercise& exercise) const {
  std::vector<Answer> chosen;
  for (const Answer& answer : answers_to_judge(exercise)) {
    const bool is_right = answer.kind == "solution" || answer.kind == "other";
    const bool is_starter = answer.kind == "starter";
    if ((is_right && solutions) || (is_starter && starters) ||
        (!is_right && !is_starter && mutants)) {
      chosen.push_back(answer);
    }
    if (is_right && fair) chosen.push_back({answer.kind, seeds});
  }
  return chosen;
}

}  // namespace lt
