#include "common/interrupt.hpp"

#include <csignal>

#include "common/command_line.hpp"

namespace lt {
namespace {

std::atomic<bool> flag{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // all that a signal handler may touch

extern "C" void on_signal(int signal) {
  flag = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

const std::atomic<bool>& interrupted() {
  static const bool is_installed = [] {
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
    return true;
  }();
  (void)is_installed;
  return flag;
}

int run_interruptible_program(const std::string& program,
                              const std::function<void(const std::atomic<bool>& cancel)>& body) {
  const std::atomic<bool>& cancel = interrupted();
  const int code = run_program(program, [&] { body(cancel); });
  return code == 0 && cancel ? interrupted_exit_code : code;
}

}  // namespace lt
