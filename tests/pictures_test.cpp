// The stored pictures are the ones that the code makes.
#include <string_view>

#include "common/files.hpp"
#include "common/testkit/catch.hpp"
#include "tests/house/descriptions.hpp"
#include "tests/house/picture_compare.hpp"
#include "tests/house/process.hpp"
#include "tests/house/programs.hpp"

using namespace lt::house;

namespace {

lt::Pixels8 grey(int width, int height) {
  const std::size_t codes = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3;
  return {width, height, std::vector<std::uint8_t>(codes, 100)};
}

// What `drift` says of a grey picture and one with `codes` added to `pixels` of its pixels.
std::string drift_after(std::size_t pixels, int codes) {
  const TemporaryFolder folder;
  lt::Pixels8 picture = grey(100, 50);
  lt::write_png(folder.path() / "old.png", picture);
  for (std::size_t i = 0; i < pixels * 3; ++i) {
    picture.rgb[i] = static_cast<std::uint8_t>(picture.rgb[i] + codes);
  }
  lt::write_png(folder.path() / "new.png", picture);
  return drift(folder.path() / "old.png", folder.path() / "new.png");
}

// Sanitizers take ten times as long, and their programs make the same pictures: there each is made
// in a sixth of its size, to see that the program runs, and not compared.
constexpr bool is_sanitized = std::string_view(LT_SANITIZE) != "";
constexpr int shrunk = is_sanitized ? 6 : 1;

// The command that makes a picture at its stored size.
std::vector<std::string> command_of(const Program& program, const lt::Picture& picture,
                                    const std::filesystem::path& out) {
  std::vector<std::string> command = {program.file.string()};
  command.insert(command.end(), picture.args.begin(), picture.args.end());
  if (picture.stored) {
    for (const std::string& word :
         {std::string("--width"), std::to_string(picture.stored->width / shrunk),
          std::string("--height"), std::to_string(picture.stored->height / shrunk)}) {
      command.push_back(word);
    }
  }
  command.insert(command.end(), {"--out", out.string()});
  return command;
}

}  // namespace

TEST_CASE("pictures: last bits and single pixels may differ - more may not") {
  CHECK(drift_after(0, 0) == "");
  CHECK(drift_after(5000, 1) == "");  // every code by one: the rounding of another compiler
  CHECK(drift_after(5, 100) == "");   // one pixel in a thousand: an edge
  CHECK(drift_after(6, 100) != "");   // more than one in a thousand
  CHECK(drift_after(5000, 2) != "");  // every code by two
}

TEST_CASE("pictures: another size and another drawing are told") {
  const TemporaryFolder folder;
  lt::write_png(folder.path() / "old.png", grey(4, 2));
  lt::write_png(folder.path() / "new.png", grey(2, 4));
  CHECK(drift(folder.path() / "old.png", folder.path() / "new.png") ==
        "is 4 x 2, and the program makes 2 x 4");
  lt::write_file_whole(folder.path() / "old.svg", "<svg>1</svg>");
  lt::write_file_whole(folder.path() / "new.svg", "<svg>2</svg>");
  CHECK(drift(folder.path() / "old.svg", folder.path() / "new.svg") == "its text has changed");
  CHECK(drift(folder.path() / "old.svg", folder.path() / "old.svg") == "");
}

TEST_CASE("pictures: every stored picture is the one that its command makes") {
  const Tree tree(LT_ROOT);
  for (const Program& program : programs()) {
    Findings findings;
    for (const lt::Picture& picture : read_pictures(tree, program.chapter, findings)) {
      if (!picture.is_stored) continue;
      const TemporaryFolder folder;
      const std::filesystem::path fresh = folder.path() / picture.file;
      const Outcome outcome = run(command_of(program, picture, fresh), folder.path());
      INFO(program.chapter << "/figures/" << picture.file << "\n"
                           << outcome.err << "remake it with ./learn figures");
      REQUIRE(outcome.exit_code == 0);
      if (is_sanitized) continue;
      CHECK(drift(tree.root() / "chapters" / program.chapter / "figures" / picture.file, fresh) ==
            "");
    }
    CHECK(findings == Findings{});
  }
}
