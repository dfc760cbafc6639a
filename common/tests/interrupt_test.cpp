#include "common/interrupt.hpp"

#include "common/error.hpp"
#include "common/testkit/catch.hpp"
#include "common/tests/other_process.hpp"

#ifndef _WIN32

namespace {

using Body = std::function<void(const std::atomic<bool>& cancel)>;

// The exit code of a program with this body, as text. In a child: a signal is for a whole process.
std::string exit_code_of(const Body& body) {
  return lt::test::in_child(
      [] { return true; },
      [&] { return std::to_string(lt::run_interruptible_program("program", body)); });
}

}  // namespace

TEST_CASE("interrupt: a body that is left alone ends with 0 and never sees the flag") {
  CHECK(exit_code_of([](const std::atomic<bool>& cancel) {
          if (cancel) throw std::runtime_error("cancelled");
        }) == "0");
}

TEST_CASE("interrupt: a body that is asked to stop sees the flag and ends with 128 + SIGINT") {
  for (const int signal : {SIGINT, SIGTERM})
    CHECK(exit_code_of([signal](const std::atomic<bool>& cancel) {
            std::raise(signal);
            if (!cancel) throw std::runtime_error("not cancelled");
          }) == "130");
}

TEST_CASE("interrupt: an error of a body that is asked to stop keeps its exit code") {
  CHECK(exit_code_of([](const std::atomic<bool>&) {
          std::raise(SIGINT);
          throw lt::InputError("an option");
        }) == "2");
}

#endif
