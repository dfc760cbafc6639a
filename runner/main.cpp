#include "common/command_line.hpp"
#include "runner/commands.hpp"
int main(int argc, char** argv) {
  int code = 0;
  const int failed = lt::run_program("learn", [&] {
    lt::Arguments a("judge", {argv + 2, argv + argc});
    code = lt::judge_command(lt::find_home(), a);
  });
  return failed ? failed : code;
}
