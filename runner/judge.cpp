#include "runner/judge.hpp"

#include <random>

#include "common/error.hpp"
#include "common/files.hpp"
#include "runner/text.hpp"

namespace lt {

namespace fs = std::filesystem;

namespace {

// A file name for Catch2's report, removed with everything else at the end of the run.
class ReportFile {
 public:
  ReportFile()
      : path_(fs::temp_directory_path() / ("lt-report-" + std::to_string(std::random_device{}()))) {
  }
  ~ReportFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  ReportFile(const ReportFile&) = delete;
  ReportFile& operator=(const ReportFile&) = delete;
  [[nodiscard]] std::string path() const { return path_.string(); }
  [[nodiscard]] std::string text() const {
    std::error_code ignored;
    return fs::exists(path_, ignored) ? read_file(path_) : "";
  }

 private:
  fs::path path_;
};

bool starts(const std::string& text, std::string_view with) {
  return text.starts_with(with);
}

}  // namespace

AnswerRun run_answer(const Exercise& exercise, const fs::path& program, const RunLimits& limits) {
  const ReportFile report;
  ProcessOptions options;
  options.seconds = limits.seconds;
  options.is_limited = limits.is_memory_limited;
  options.environment = {{"LT_FAIR_SEEDS", std::to_string(limits.seeds)}};
  AnswerRun run;
  run.result = run_process(
      {program.string(), "--reporter", "compact", "--out", report.path(), "--order", "decl"},
      options);
  if (run.result.exit_code == 127) throw OutputError("cannot run " + program.string());
  run.output =
      read_test_output(run.result.output, report.text(), read_file(exercise.folder / "test.cpp"));
  // exit(0) inside the answer is no success: Catch2 must have come to its summary.
  if (run.result.succeeded() && report.text().find("assed") == std::string::npos) {
    run.result.exit_code = 1;
  }
  return run;
}

std::vector<Answer> answers_to_judge(const Exercise& exercise) {
  std::vector<Answer> answers{{"solution"}, {"other"}, {"starter"}};
  for (const Mutant& mutant : exercise.mutants)
    answers.push_back({"mutant_" + mutant.tag});
  return answers;
}

std::string complaint(const std::string& kind, const AnswerRun& run) {
  const ProcessResult& result = run.result;
  const TestOutput& output = run.output;
  if (result.timed_out) return "its time was over";
  if (is_sanitizer_report(result.output)) return "a sanitizer stopped it";
  if (result.signal != 0) return "it crashed: " + signal_in_words(result.signal);

  const std::set<std::string> tags = output.tags();
  const std::string named =
      tags.empty() ? "no mistake" : join(std::vector<std::string>(tags.begin(), tags.end()), ", ");
  if (kind == "solution" || kind == "other") {
    if (!tags.empty()) return "it is right, but was named " + named;
    if (output.not_written) return "it is not written";
    if (result.succeeded()) return "";
    const auto& check = output.failed_check;
    return check ? "it is right, but \"" + check->sentence + "\" failed: " + check->expression +
                       (check->values.empty() ? "" : " (" + check->values + ")")
                 : "it is right, but ended with exit code " + std::to_string(result.exit_code);
  }
  if (result.succeeded()) return "it passed, and must not";
  if (kind == "starter") {
    if (!output.not_written) return "it failed, but not because of TODO(...)";
    return tags.empty() ? "" : "it is not written, but was named " + named;
  }
  if (output.not_written) return "it is not written";
  const std::string tag = starts(kind, "mutant_") ? kind.substr(7) : kind;
  return tags == std::set<std::string>{tag} ? ""
                                            : "it must be named " + tag + " and was named " + named;
}

std::string sentence_of(const Exercise& exercise, const Answer& answer) {
  const std::string start = exercise.id + " " + exercise.name + ": ";
  const std::string seeds =
      answer.seeds > 1 ? " for " + std::to_string(answer.seeds) + " seeds" : "";
  if (answer.kind == "solution") return start + "the solution passes" + seeds;
  if (answer.kind == "other") return start + "another right answer passes" + seeds;
  if (answer.kind == "starter") return start + "the starter fails because it is not written";
  return start + "the mutant " + answer.kind.substr(7) + " is named";
}

}  // namespace lt
