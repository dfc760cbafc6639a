#include "tests/house/programs.hpp"

#include "common/files.hpp"
#include "runner/text.hpp"

namespace lt::house {

std::vector<Program> programs() {
  std::vector<Program> found;
  for (const std::string& line : split_lines(read_file(LT_PROGRAMS))) {  // "chapter path"
    const std::size_t blank = line.find(' ');
    found.push_back({line.substr(0, blank), line.substr(blank + 1)});
  }
  return found;
}

}  // namespace lt::house
