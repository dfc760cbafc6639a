#include "tests/house/descriptions.hpp"

#include "common/error.hpp"

namespace lt::house {
namespace {

// The reader's line without the file's name at its start, which the finding names itself.
Finding refused(const std::string& file, const InputError& error) {
  const std::string line = error.what();
  const std::string name = file + ": ";
  return {file, 0, line.starts_with(name) ? line.substr(name.size()) : line};
}

}  // namespace

std::vector<Picture> read_pictures(const Tree& tree, const std::string& chapter,
                                   Findings& findings) {
  const std::string file = "chapters/" + chapter + "/pictures.json";
  try {
    return parse_pictures(tree.text(file), chapter, file);
  } catch (const InputError& error) {
    findings.push_back(refused(file, error));
    return {};
  }
}

std::optional<Exercise> read_exercise(const Tree& tree, const std::string& file,
                                      Findings& findings) {
  try {
    return parse_exercise(tree.text(file), file);
  } catch (const InputError& error) {
    findings.push_back(refused(file, error));
    return std::nullopt;
  }
}

}  // namespace lt::house
