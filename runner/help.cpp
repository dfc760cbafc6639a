#include "runner/help.hpp"

#include "runner/terminal.hpp"
#include "runner/text.hpp"

namespace lt {

namespace {

std::string usage(const Command& command) {
  std::string text = "./learn";
  if (!command.name.empty()) text += " " + command.name;
  if (!command.usage.empty()) text += " " + command.usage;
  return text;
}

}  // namespace

std::string help_text(const std::vector<Command>& commands) {
  std::string text = ink::bold("Tracing Light") + ": a course that builds a renderer.\n";
  std::string group;
  for (const Command& command : commands) {
    if (command.group.empty()) continue;
    if (command.group != group) {
      group = command.group;
      text += "\n" + ink::bold(group) + "\n";
    }
    text += "  " + ink::cyan(padded(usage(command), 38)) + " " + command.summary + "\n";
  }
  return text + "\n./learn help COMMAND tells more of one of them.\n";
}

std::string help_text(const Command& command) {
  const int width = terminal_columns();
  std::string text = ink::cyan(usage(command)) + "\n" + wrapped(command.summary, width, 2);
  if (!command.details.empty()) text += "\n" + wrapped(command.details, width, 2);
  return text;
}

}  // namespace lt
