// ./learn: finds the command, runs it, and turns what it throws into one line and an exit code.
#include <iostream>

#include "common/command_line.hpp"
#include "common/error.hpp"
#include "common/files.hpp"
#include "runner/build.hpp"
#include "runner/commands.hpp"
#include "runner/help.hpp"
#include "runner/process.hpp"
#include "runner/text.hpp"

namespace lt {

namespace {

std::vector<Command> all_commands() {
  std::vector<Command> commands = exercise_commands();
  for (Command& command : course_commands())
    commands.push_back(std::move(command));
  return commands;
}

const Command& find_command(const std::vector<Command>& commands, const std::string& name) {
  std::vector<std::string> names{"help"};
  for (const Command& command : commands) {
    if (command.name == name) return command;
    if (!command.group.empty() && !command.name.empty()) names.push_back(command.name);
  }
  throw InputError("there is no command \"" + printable(name) + "\"" +
                   did_you_mean(name, names, "./learn help lists them all"));
}

bool asks_for_help(const std::string& word) {
  return word == "help" || word == "--help" || word == "-h";
}

int dispatch(std::vector<std::string> words) {
  const std::vector<Command> commands = all_commands();
  if (!words.empty() && asks_for_help(words[0])) {
    if (words.size() > 2) throw InputError("help takes one command; see ./learn help");
    std::cout << (words.size() == 2 ? help_text(find_command(commands, words[1]))
                                    : help_text(commands));
    return 0;
  }
  const std::string name = words.empty() ? "" : words[0];
  const Command& command = find_command(commands, name);
  if (!words.empty()) words.erase(words.begin());
  const bool wants_help = words.size() == 1 && asks_for_help(words[0]) && name != "chapter";
  if (wants_help) {
    std::cout << help_text(command);
    return 0;
  }
  Arguments arguments(name, std::move(words));
  return command.run(find_home(), arguments);
}

}  // namespace

}  // namespace lt

int main(int argc, char** argv) {
  constexpr int interrupted = 130;
  lt::catch_interrupts();
  int code = 0;
  const int failed = lt::run_program("learn", [&] {
    try {
      code = lt::dispatch({argv + std::min(1, argc), argv + argc});
    } catch (const lt::BuildFailed& failure) {
      std::cerr << failure.what();
      throw lt::OutputError("the build failed: see above");
    } catch (const lt::Interrupted&) {
      std::cout << std::endl;
      code = interrupted;
    }
  });
  return failed != 0 ? failed : code;
}
