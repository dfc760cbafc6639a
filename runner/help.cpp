#include "runner/help.hpp"

#include <array>

#include "runner/terminal.hpp"
#include "runner/text.hpp"

namespace lt {

namespace {

// As one types it.
std::string usage(const Command& command) {
  std::string line = "./learn";
  for (const std::string& part : {command.name, command.usage})
    if (!part.empty()) line += " " + part;
  return line;
}

// In the order in which a newcomer wants them.
constexpr std::array groups = {"Exercises", "The course", "Upkeep"};

}  // namespace

std::string help_text(const std::vector<Command>& commands) {
  std::string text = "usage: ./learn [COMMAND]\n";
  for (const std::string group : groups) {
    text += "\n" + ink::bold(group) + "\n";
    for (const Command& command : commands) {
      if (command.group != group) continue;
      text += "  " + ink::cyan(padded(usage(command), 36)) + "  " + command.summary + "\n";
    }
  }
  return text + "\n./learn help COMMAND tells more of one of them.\n";
}

std::string help_text(const Command& command) {
  const int width = terminal_columns();
  std::string text = "usage: " + usage(command) + "\n\n" + wrapped(command.summary, width, 2);
  if (!command.details.empty()) text += "\n" + wrapped(command.details, width, 2);
  return text;
}

}  // namespace lt
