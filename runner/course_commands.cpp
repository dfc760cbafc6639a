#include "runner/commands.hpp"
namespace lt {
std::vector<Command> course_commands() {
  return {};
}
}  // namespace lt
