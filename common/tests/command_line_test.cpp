#include "common/command_line.hpp"

#include <initializer_list>
#include <iostream>
#include <sstream>

#include "common/error.hpp"
#include "common/pixel_io.hpp"
#include "common/testkit/catch.hpp"
#include "common/tests/temporary_folder.hpp"

using namespace lt::test;

namespace {

// What a stream is given while this lives.
class Captured {
 public:
  explicit Captured(std::ostream& stream) : stream_(stream), before_(stream.rdbuf(text_.rdbuf())) {}
  ~Captured() { stream_.rdbuf(before_); }
  Captured(const Captured&) = delete;
  Captured& operator=(const Captured&) = delete;
  [[nodiscard]] std::string text() const { return text_.str(); }

 private:
  std::ostream& stream_;
  std::ostringstream text_;
  std::streambuf* before_;
};

// A program with one option of every kind.
struct Program {
  lt::RenderOptions render;
  float exposure = 0;
  bool flat = false;
  std::string view = "normals";

  bool parse(std::initializer_list<const char*> arguments) {
    lt::CommandLine line("program", "Tries every kind of option.");
    lt::add_picture_options(line, render);
    lt::add_sampling_options(line, render);
    line.add_float("--exposure", exposure, -10, 10.5f, "exposure in stops");
    line.add_flag("--flat", flat, "flat normals");
    line.add_choice("--view", view, {"normals", "depth"}, "what to show");
    std::vector<const char*> argv = {"program"};
    argv.insert(argv.end(), arguments);
    return line.parse(static_cast<int>(argv.size()), argv.data());
  }
};

std::string complaint(std::initializer_list<const char*> arguments) {
  Program program;
  return input_error([&] { (void)program.parse(arguments); });
}

}  // namespace

TEST_CASE("command line: without options the defaults stay") {
  Program program;
  REQUIRE(program.parse({}));
  CHECK(program.render.width == 900);
  CHECK(program.render.height == 720);
  CHECK(program.render.seed == 1);
  CHECK(program.render.out.empty());
  CHECK(program.view == "normals");
  CHECK_FALSE(program.flat);
}

TEST_CASE("command line: every kind of option is understood, in both spellings") {
  Program program;
  REQUIRE(program.parse({"--width", "3", "--height=16384", "--spp", "64", "--seed",
                         "18446744073709551615", "--threads=0", "--exposure", "-1.5", "--flat",
                         "--view", "depth", "--out", "a folder/b.png"}));
  CHECK(program.render.width == 3);
  CHECK(program.render.height == lt::max_image_side);
  CHECK(program.render.samples_per_pixel == 64);
  CHECK(program.render.seed == 18446744073709551615u);
  CHECK(program.exposure == -1.5f);
  CHECK(program.flat);
  CHECK(program.view == "depth");
  CHECK(program.render.out == "a folder/b.png");
}

TEST_CASE("command line: the last of several values counts, ranges include both ends") {
  Program program;
  REQUIRE(program.parse({"--width", "7", "--width", "16384", "--exposure", "10.5", "--spp=1"}));
  CHECK(program.render.width == 16384);
  CHECK(program.exposure == 10.5f);
}

TEST_CASE("command line: a value that is none is refused in one line that says what is taken") {
  struct Case {
    std::initializer_list<const char*> arguments;
    const char* option;
    const char* takes;
  };
  const char* width_takes = "a whole number from 1 to 16384";
  const char* exposure_takes = "a number from -10 to 10.5";
  for (const Case& bad : {
           Case{{"--width"}, "--width", width_takes},
           Case{{"--width", "--height", "3"}, "--width", width_takes},
           Case{{"--width", "12abc"}, "--width", width_takes},
           Case{{"--width", "abc"}, "--width", width_takes},
           Case{{"--width", "1.5"}, "--width", width_takes},
           Case{{"--width", " 5"}, "--width", width_takes},
           Case{{"--width", "5\n6"}, "--width", width_takes},
           Case{{"--width", "0x10"}, "--width", width_takes},
           Case{{"--width", "0"}, "--width", width_takes},
           Case{{"--width", "-5"}, "--width", width_takes},
           Case{{"--width", "16385"}, "--width", width_takes},
           Case{{"--width", "99999999999999999999"}, "--width", width_takes},
           Case{{"--width", ""}, "--width", width_takes},
           Case{{"--width="}, "--width", width_takes},
           Case{{"--spp", "1e3"}, "--spp", "a whole number from 1 to 1000000"},
           Case{{"--exposure", "nan"}, "--exposure", exposure_takes},
           Case{{"--exposure", "inf"}, "--exposure", exposure_takes},
           Case{{"--exposure", "1e99"}, "--exposure", exposure_takes},
           Case{{"--exposure", "11"}, "--exposure", exposure_takes},
           Case{{"--exposure", "1,5"}, "--exposure", exposure_takes},
           Case{{"--exposure", "1.5x"}, "--exposure", exposure_takes},
           Case{{"--exposure", ""}, "--exposure", exposure_takes},
           Case{{"--seed", "-1"}, "--seed", "from 0 to 18446744073709551615"},
           Case{{"--seed", "18446744073709551616"}, "--seed", "from 0 to 18446744073709551615"},
           Case{{"--view", "colour"}, "--view", "normals, depth"},
           Case{{"--view", ""}, "--view", "normals, depth"},
           Case{{"--flat=3"}, "--flat", "no value"},
           Case{{"--out"}, "--out", "a path"},
           Case{{"--out", "--flat"}, "--out", "a path"},
           Case{{"--out", ""}, "--out", "a path"},
       }) {
    const std::string line = complaint(bad.arguments);
    INFO(line);
    CHECK(contains(line, std::string(bad.option) + " takes "));
    CHECK(contains(line, bad.takes));
    CHECK_FALSE(contains(line, "\n"));
  }
}

TEST_CASE("command line: an unknown option is named in one line, with the nearest that there is") {
  for (const char* unknown : {"--colour", "-w", "word", "--", "--a\nb", ""}) {
    const std::string line = complaint({unknown, "3"});
    INFO(line);
    CHECK(contains(line, "--help"));
    CHECK_FALSE(contains(line, "\n"));
  }
  CHECK(contains(complaint({"--colour", "3"}), "--colour"));
  CHECK(contains(complaint({"word"}), "word"));
  CHECK(contains(complaint({"--widht", "3"}), "--width"));
}

TEST_CASE("command line: a refused value leaves the default") {
  Program program;
  CHECK_THROWS_AS(program.parse({"--width", "0"}), lt::InputError);
  CHECK(program.render.width == 900);
}

TEST_CASE("command line: an option that changes nothing beside the others is refused") {
  const auto complaint = [](std::initializer_list<const char*> arguments) {
    std::string view = "room";
    std::string camera = "far";
    std::string wall = "west";
    bool flat = false;
    lt::CommandLine line("program", "Has options that only some views use.");
    line.add_choice("--view", view, {"room", "depth", "plan", "globe"}, "what to show");
    line.add_choice("--camera", camera, {"far", "near"}, "where to stand");
    line.add_choice("--wall", wall, {"west", "east"}, "which wall");
    line.add_flag("--flat", flat, "flat normals");
    line.only_for("--camera", "--view", {"room", "depth", "plan"});
    line.only_for("--flat", "--view", {"room"});
    line.needs("--wall", "--camera");
    std::vector<const char*> argv = {"program"};
    argv.insert(argv.end(), arguments);
    return input_error([&] { (void)line.parse(static_cast<int>(argv.size()), argv.data()); });
  };
  const std::string fine = "(no error)";
  CHECK(complaint({"--view", "globe", "--camera", "near"}) ==
        "--camera is for --view room, depth or plan; leave it out for --view globe");
  CHECK(complaint({"--view", "globe", "--camera", "far"}) != fine);  // even with its default
  CHECK(complaint({"--flat", "--view", "plan"}) ==
        "--flat is for --view room; leave it out for --view plan");
  CHECK(complaint({"--wall", "east"}) == "--wall needs --camera; add it, or leave --wall out");
  CHECK(complaint({}) == fine);
  CHECK(complaint({"--flat"}) == fine);  // for the default view
  CHECK(complaint({"--view", "plan", "--camera", "near", "--wall", "east"}) == fine);
  CHECK(complaint({"--view", "globe"}) == fine);
}

TEST_CASE("command line: help goes to standard output and ends the program well") {
  const Captured out(std::cout);
  Program program;
  CHECK_FALSE(program.parse({"--help"}));
  for (const char* part : {"Tries every kind", "--width", "1..16384", "900", "normals|depth",
                           "flat normals", "--seed", "--threads", "--spp", "--out"}) {
    INFO(part);
    CHECK(contains(out.text(), part));
  }
}

TEST_CASE("programs: errors become one line on standard error and an exit code") {
  const auto run = [](const auto& error) {
    const Captured err(std::cerr);
    const int code = lt::run_program("ch99", [&] { throw error; });
    return std::to_string(code) + " " + err.text();
  };
  CHECK(run(lt::InputError("no such scene")) == "2 ch99: no such scene\n");
  CHECK(run(lt::OutputError("disk full")) == "1 ch99: disk full\n");
  CHECK(run(std::runtime_error("two\nlines")) == "1 ch99: two?lines\n");
  CHECK(run(std::bad_alloc()) == "1 ch99: not enough memory; ask for less\n");
  CHECK(lt::run_program("ch99", [] {}) == 0);
}
