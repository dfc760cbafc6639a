#include "tests/house/programs.hpp"

#include "common/files.hpp"
#include "runner/text.hpp"

namespace lt::house {
namespace {

std::vector<Program> all_programs() {
  std::vector<Program> found;
  for (const std::string& line : split_lines(read_file(LT_PROGRAMS))) {  // "name path"
    const std::size_t blank = line.find(' ');
    found.push_back({line.substr(0, blank), line.substr(blank + 1)});
  }
  return found;
}

}  // namespace

std::vector<Program> programs() {
  std::vector<Program> found = all_programs();
  std::erase_if(found, [](const Program& program) { return program.chapter == "learn"; });
  return found;
}

std::filesystem::path learn_program() {
  return all_programs().front().file;
}

}  // namespace lt::house
