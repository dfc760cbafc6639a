/// @file
/// The commands of `./learn`.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "runner/arguments.hpp"
#include "runner/home.hpp"

namespace lt {

/// One command: what --help says of it, and what it does.
struct Command {
  std::string name;
  std::string group;    ///< headline in --help; "" hides it
  std::string usage;    ///< what may follow the name: "[ID] [--anyway]"
  std::string summary;  ///< half a sentence
  std::string details;  ///< options and examples, for `./learn help NAME`
  std::function<int(const Home&, Arguments&)> run;  ///< returns the exit code
};

/// The exercises: learn (with no word), next, list, run, hint, solution, reset, verify, judge.
[[nodiscard]] std::vector<Command> exercise_commands();

/// The course: render, chapter, figures, snippets, test, bench, site, doctor.
[[nodiscard]] std::vector<Command> course_commands();

/// What is measured of the whole course: `test` and `bench`.
/// @return the exit code: 0 if every test passes, or if the benchmarks ran
int test_command(const Home& home, Arguments& arguments);
int bench_command(const Home& home, Arguments& arguments);

/// What is proved of the exercises: `verify --all` and its hidden parts.
/// @return the exit code: 0 if everything holds
int verify_command(const Home& home, Arguments& arguments);
int judge_command(const Home& home, Arguments& arguments);
int measure_edits_command(const Home& home, Arguments& arguments);

}  // namespace lt
