// Every chapter's program as a person meets it who asks for help, mistypes, or has a full disk.
#include "tests/house/programs.hpp"

#include <algorithm>

#include "common/files.hpp"
#include "common/testkit/catch.hpp"
#include "tests/house/chapters.hpp"
#include "tests/house/process.hpp"

using namespace lt::house;

namespace {

using Words = std::vector<std::string>;

Outcome run_in(const std::filesystem::path& folder, const Program& program, const Words& words) {
  Words command = {program.file.string()};
  command.insert(command.end(), words.begin(), words.end());
  return run(command, folder);
}

std::string shown(const Program& program, const Words& words) {
  std::string line = program.chapter;
  for (const std::string& word : words)
    line += " " + word;
  return line;
}

// One line on stderr that starts with the program's name and says `names`; nothing else printed.
void check_one_line(const Program& program, const Outcome& outcome, const std::string& names) {
  INFO("stderr: " << outcome.err);
  CHECK(outcome.out.empty());
  CHECK(std::ranges::count(outcome.err, '\n') == 1);
  CHECK(outcome.err.starts_with(program.chapter + ": "));
  CHECK(outcome.err.find(names) != std::string::npos);
}

}  // namespace

TEST_CASE("programs: there is one for every chapter") {
  std::vector<std::string> chapters;
  for (const Program& program : programs())
    chapters.push_back(program.chapter);
  CHECK(chapters == chapters_of(Tree(LT_ROOT)));
}

TEST_CASE("programs: --help says what a program takes and ends well") {
  for (const Program& program : programs()) {
    const TemporaryFolder folder;
    const Outcome outcome = run_in(folder.path(), program, {"--help"});
    INFO(program.chapter);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.empty());
    for (const std::string option : {"--width", "--height", "--out", "--help"}) {
      CHECK(outcome.out.find(option) != std::string::npos);
    }
    CHECK(std::filesystem::is_empty(folder.path()));
  }
}

TEST_CASE("programs: bad input ends with one line that names it - exit code 2 - and no file") {
  struct Mistake {
    Words words;
    std::string names;
  };
  const std::vector<Mistake> mistakes = {
      {{"--no-such-option"}, "--no-such-option"},
      {{"stray"}, "stray"},
      {{"--width", "0"}, "--width"},
      {{"--width", "-5"}, "--width"},
      {{"--width", "abc"}, "--width"},
      {{"--width", "12.5"}, "--width"},
      {{"--width", "1000000000"}, "--width"},
      {{"--width", "99999999999999999999"}, "--width"},
      {{"--height", ""}, "--height"},
      {{"--height"}, "--height"},
      {{"--out"}, "--out"},
      {{"--out", "picture.bmp"}, "picture.bmp"},
      {{"--out", "picture"}, "picture"},
  };
  for (const Program& program : programs()) {
    for (const Mistake& mistake : mistakes) {
      const TemporaryFolder folder;
      const Outcome outcome = run_in(folder.path(), program, mistake.words);
      INFO(shown(program, mistake.words));
      CHECK(outcome.exit_code == 2);
      check_one_line(program, outcome, mistake.names);
      CHECK(std::filesystem::is_empty(folder.path()));
    }
  }
}

TEST_CASE("programs: an option that the view does not use is refused") {
  struct Mistake {
    std::string chapter;
    Words words;
    std::string names;
  };
  const std::vector<Mistake> mistakes = {
      {"ch01_pixels", {"--plot", "curve", "--wrong"}, "--wrong"},
      {"ch01_pixels", {"--plot", "steps", "--stops", "1"}, "--stops"},
      {"ch02_ray_casting", {"--measure"}, "--measure"},
      {"ch02_ray_casting", {"--plot", "cost", "--view", "far"}, "--view"},
      {"ch02_ray_casting", {"--plot", "cost", "--threads", "2"}, "--threads"},
      {"ch02_ray_casting", {"--view", "far", "--fov", "30"}, "--fov"},
      {"ch02_ray_casting", {"--view", "far-naive", "--camera", "near"}, "--camera"},
      {"ch03_surfaces", {"--view", "balls", "--texture", "nosuch.jpg"}, "--texture"},
      {"ch03_surfaces", {"--view", "uv", "--texture", "nosuch.jpg"}, "--texture"},
      {"ch03_surfaces", {"--view", "globe", "--camera", "near"}, "--camera"},
      {"ch03_surfaces", {"--view", "uv", "--normal-maps", "off"}, "--normal-maps"},
      {"ch03_surfaces", {"--view", "spin", "--texture-on", "wall"}, "--texture-on"},
      {"ch03_surfaces", {"--texture-on", "wall"}, "--texture-on"},
      {"ch03_surfaces", {"--view", "seam", "--rotate", "9"}, "--rotate"},
      {"ch03_surfaces", {"--view", "filter", "--texels", "64"}, "--texels"},
      {"ch03_surfaces", {"--view", "maps", "--grid", "2"}, "--grid"},
      {"ch03_surfaces", {"--view", "globe", "--wrong"}, "--wrong"},
      {"ch04_monte_carlo", {"--view", "dots", "--stratified"}, "--stratified"},
      {"ch04_monte_carlo", {"--streams", "same"}, "--streams"},
      {"ch04_monte_carlo", {"--view", "evening", "--samples", "99"}, "--samples"},
      {"ch04_monte_carlo", {"--view", "strip", "--spp", "4"}, "--spp"},
      {"ch04_monte_carlo", {"--view", "dots", "--threads", "2"}, "--threads"},
      {"ch04_monte_carlo", {"--plot", "thesis", "--view", "darts"}, "--view"},
      {"ch04_monte_carlo", {"--plot", "thesis", "--samples", "99"}, "--samples"},
      {"ch04_monte_carlo", {"--table", "errors", "--plot", "pi"}, "--plot"},
      {"ch04_monte_carlo", {"--table", "errors", "--out", "errors.svg"}, "--out"},
      {"ch04_monte_carlo", {"--table", "errors", "--samples", "99"}, "--samples"},
      {"ch04_monte_carlo", {"--table", "costs", "--seed", "2"}, "--seed"},
      {"ch05_rendering_equation", {"--view", "strip", "--camera", "near"}, "--camera"},
      {"ch05_rendering_equation", {"--view", "strip", "--spp", "4"}, "--spp"},
      {"ch05_rendering_equation", {"--plot", "noise", "--view", "strip"}, "--view"},
      {"ch05_rendering_equation", {"--plot", "noise", "--spp", "4"}, "--spp"},
      {"ch05_rendering_equation", {"--plot", "furnace", "--depth", "1"}, "--depth"},
      {"ch05_rendering_equation", {"--plot", "furnace", "--wrong", "pi"}, "--wrong"},
      {"ch06_importance_sampling", {"--view", "cosine", "--uniform-spp", "4"}, "--uniform-spp"},
      {"ch06_importance_sampling", {"--view", "pair", "--directions", "9"}, "--directions"},
      {"ch06_importance_sampling", {"--view", "directions", "--sampler", "uniform"}, "--sampler"},
      {"ch06_importance_sampling", {"--view", "directions", "--spp", "4"}, "--spp"},
      {"ch06_importance_sampling", {"--view", "bins", "--camera", "near"}, "--camera"},
      {"ch06_importance_sampling",
       {"--view", "bins", "--sampler", "uniform", "--wrong", "root"},
       "--sampler"},
      {"ch06_importance_sampling", {"--plot", "noise", "--camera", "near"}, "--camera"},
      {"ch06_importance_sampling", {"--plot", "heights", "--wrong", "root"}, "--wrong"},
      {"ch06_importance_sampling", {"--table", "efficiency", "--view", "pair"}, "--view"},
      {"ch06_importance_sampling", {"--table", "efficiency", "--threads", "2"}, "--threads"},
      {"ch06_importance_sampling", {"--table", "efficiency", "--plot", "noise"}, "--plot"},
  };
  for (const Program& program : programs()) {
    for (const Mistake& mistake : mistakes) {
      if (mistake.chapter != program.chapter) continue;
      const TemporaryFolder folder;
      Words words = mistake.words;
      words.insert(words.end(), {"--width", "8", "--height", "8"});
      const Outcome outcome = run_in(folder.path(), program, words);
      INFO(shown(program, words));
      CHECK(outcome.exit_code == 2);
      check_one_line(program, outcome, mistake.names + " ");
      CHECK(std::filesystem::is_empty(folder.path()));
    }
  }
}

TEST_CASE("programs: a place that cannot be written ends with one line and exit code 1") {
  for (const Program& program : programs()) {
    const TemporaryFolder folder;
    lt::write_file_whole(folder.path() / "file", "not a folder");
    std::filesystem::create_directory(folder.path() / "folder.png");
    for (const std::string out : {"file/picture.png", "folder.png"}) {
      const Words words = {"--width", "8", "--height", "8", "--out", out};
      const Outcome outcome = run_in(folder.path(), program, words);
      INFO(shown(program, words) << "\nstderr: " << outcome.err);
      CHECK(outcome.exit_code == 1);
      CHECK(outcome.err.find(out) != std::string::npos);
      CHECK(lt::read_file(folder.path() / "file") == "not a folder");
      CHECK(std::filesystem::is_empty(folder.path() / "folder.png"));
    }
    const auto entries = std::filesystem::directory_iterator(folder.path());
    CHECK(std::distance(begin(entries), end(entries)) == 2);  // nothing half-written is left
  }
}
