// The commands about the course itself: render, chapter, figures, snippets, test, bench, site,
// doctor.
#include <algorithm>
#include <iostream>

#include "common/error.hpp"
#include "common/files.hpp"
#include "runner/build.hpp"
#include "runner/commands.hpp"
#include "runner/contact_sheet.hpp"
#include "runner/pictures.hpp"
#include "runner/process.hpp"
#include "runner/snippets.hpp"
#include "runner/terminal.hpp"
#include "runner/text.hpp"

namespace lt {

namespace fs = std::filesystem;

namespace {

// The first line of a chapter's README without its "# ".
std::string chapter_title(const Home& home, const std::string& chapter) {
  const fs::path readme = home.root / "chapters" / chapter / "README.md";
  if (!fs::exists(readme)) return chapter;
  const std::vector<std::string> lines = split_lines(read_file(readme));
  return !lines.empty() && lines[0].starts_with("# ") ? lines[0].substr(2) : chapter;
}

SheetPicture sheet_picture(const Home& home, const PictureJob& job) {
  const std::string link = job.picture.chapter + "/" + job.picture.file;
  const std::string bytes = read_file(job.out);
  const PictureSize size = png_size(bytes);
  std::string details = human_size(bytes.size());
  if (size.width > 0) {
    details = std::to_string(size.width) + " x " + std::to_string(size.height) + ", " + details;
  }
  return {chapter_title(home, job.picture.chapter),
          link,
          job.picture.title,
          job.picture.caption,
          picture_command(job.picture, job.size, "out/" + link),
          details};
}

void build_programs(const Home& home) {
  configure(home, "release");
  build(home.build(), {"render_programs"}, "building the chapters' programs");
}

int render_command(const Home& home, Arguments& arguments) {
  const bool is_quick = arguments.flag("--quick");
  const bool is_built = arguments.flag("--built");  // CMake's target `render` has built them
  arguments.nothing_more();
  std::vector<PictureJob> jobs;
  for (const Picture& picture : load_pictures(home, chapter_names(home))) {
    jobs.push_back(
        {picture, render_size(picture, is_quick), home.out / picture.chapter / picture.file});
  }
  if (!is_built) build_programs(home);
  make_pictures(home, jobs, "rendering " + std::to_string(jobs.size()) + " pictures");

  std::vector<SheetPicture> sheet;
  for (const PictureJob& job : jobs)
    sheet.push_back(sheet_picture(home, job));
  const fs::path page = home.out / "index.html";
  write_file_whole(page, contact_sheet(sheet));
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    std::cout << padded(shown_path(jobs[i].out), 56) << ink::dim(sheet[i].details) << '\n';
  }
  std::cout << shown_path(page) << "  (all of them on one page)" << std::endl;
  return 0;
}

int chapter_command(const Home& home, Arguments& arguments) {
  std::vector<std::string> words = arguments.all_left();
  if (words.empty() || words[0].starts_with("-")) {
    throw InputError("chapter takes a number first: ./learn chapter 2 --help");
  }
  const std::string chapter = find_chapter(home, words[0]);
  configure(home, "release");
  build(home.build(), {chapter}, "building " + chapter);
  words[0] = built_program(home.build() / "chapters" / chapter, chapter).string();
  const ProcessResult result = run_visibly(words);
  if (result.signal != 0) {
    throw OutputError(chapter + " crashed: " + signal_in_words(result.signal));
  }
  return result.exit_code;
}

int figures_command(const Home& home, Arguments& arguments) {
  const std::string word = arguments.word_or_nothing();
  const std::vector<std::string> chapters =
      word.empty() ? chapter_names(home) : std::vector<std::string>{find_chapter(home, word)};
  std::vector<PictureJob> jobs;
  for (const Picture& picture : load_pictures(home, chapters)) {
    if (!picture.is_stored) continue;
    jobs.push_back({picture, picture.stored.value_or(PictureSize{}),
                    home.root / "chapters" / picture.chapter / "figures" / picture.file});
  }
  if (jobs.empty()) {
    std::cout << "No stored figures are listed there.\n";
    return 0;
  }
  build_programs(home);
  make_pictures(home, jobs, "making " + std::to_string(jobs.size()) + " figures");

  constexpr std::uintmax_t largest = 200'000;
  int too_large = 0;
  for (const PictureJob& job : jobs) {
    const std::uintmax_t size = fs::file_size(job.out);
    std::cout << padded(shown_path(job.out), 60) << human_size(size);
    if (size > largest) std::cout << ink::red("  more than 200 KB");
    std::cout << '\n';
    too_large += size > largest ? 1 : 0;
  }
  if (too_large > 0) throw OutputError("stored figures must not be larger than 200 KB");
  return 0;
}

int snippets_command(const Home& home, Arguments& arguments) {
  const bool is_check = arguments.flag("--check");
  arguments.nothing_more();
  int drifted = 0;
  int broken = 0;
  for (const std::string& chapter : chapter_names(home)) {
    const fs::path readme = home.root / "chapters" / chapter / "README.md";
    if (!fs::exists(readme)) continue;
    const FreshText fresh = chapter_with_fresh_snippets(home, chapter);
    for (const SnippetProblem& problem : fresh.drifted) {
      ++drifted;
      std::cout << shown_path(readme) << ":" << problem.line << ": " << problem.what
                << (is_check ? " differs from the file; ./learn snippets rewrites it\n"
                             : " rewritten\n");
    }
    for (const SnippetProblem& problem : fresh.broken) {
      ++broken;
      std::cout << shown_path(readme) << ":" << problem.line << ": " << problem.what << '\n';
    }
    if (!is_check && !fresh.drifted.empty()) write_file_whole(readme, fresh.text);
  }
  if (drifted == 0 && broken == 0) std::cout << "All snippets are as their files.\n";
  return broken > 0 || (is_check && drifted > 0) ? 1 : 0;
}

// Runs a script of the repository.
ProcessResult run_script(const std::vector<std::string>& words, const ProcessOptions& options) {
  if (!program_exists("sh")) {
    throw InputError("this needs a POSIX shell; on Windows type it in Git Bash or WSL");
  }
  std::vector<std::string> command{"sh"};
  command.insert(command.end(), words.begin(), words.end());
  return run_visibly(command, options);
}

int site_command(const Home& home, Arguments& arguments) {
  const bool wants_server = arguments.flag("--serve");
  const int port = arguments.number("--port", 8000, 0, 65535);
  arguments.nothing_more();
  const fs::path pages = home.build("site") / "html";
  ProcessOptions options;
  options.folder = home.root;
  const ProcessResult built = run_script({"docs/build.sh", pages.generic_string()}, options);
  if (!built.succeeded()) throw OutputError("the site was not built: see above");
  if (!wants_server) return 0;
  try {
    return run_visibly({"python3", (home.root / "runner" / "serve.py").string(), pages.string(),
                        std::to_string(port)})
        .exit_code;
  } catch (const Interrupted&) {
    return 0;
  }
}

int doctor_command(const Home& home, Arguments& arguments) {
  arguments.nothing_more();
  return run_script({(home.root / "learn").generic_string(), "doctor"}, {}).exit_code;
}

}  // namespace

std::vector<Command> course_commands() {
  const std::string course = "The course";
  const std::string upkeep = "Upkeep";
  return {
      {"render", course, "[--quick]", "make every picture and a page of them",
       "--quick makes them small. out/index.html shows all with their commands.", render_command},
      {"chapter", course, "N [OPTIONS]", "build and run the program of one chapter",
       "Options go to the program: ./learn chapter 2 --help lists them.", chapter_command},
      {"test", course, "[N] [--sanitize] [-- CTEST]", "run every test, or those of one chapter",
       "N is a chapter's number; without it everything is built. --sanitize: under the address and "
       "undefined-behaviour sanitizers. What follows -- goes to ctest: ./learn test -- -R camera",
       test_command},
      {"bench", course, "[--quick]", "measure how fast the course is on this machine",
       "Needs Google Benchmark, and a machine that does nothing else. Builds with -O3 "
       "-march=native in build/bench. --quick measures less long.",
       bench_command},
      {"site", course, "[--serve] [--port N]", "build the site",
       "--serve shows it at http://127.0.0.1:8000/ (--port another).", site_command},
      {"doctor", course, "", "say what is missing and how to get it", "", doctor_command},
      {"figures", upkeep, "[N]", "make the stored pictures of the texts anew",
       "N is a chapter's number. Writes chapters/*/figures.", figures_command},
      {"snippets", upkeep, "[--check]", "copy code from the files into the texts",
       "--check only reports what differs; exit code 1 if something does.", snippets_command},
  };
}

}  // namespace lt
