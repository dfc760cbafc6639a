#include "common/progress.hpp"

#include <algorithm>
#include <thread>

#include "common/testkit/catch.hpp"
#include "common/tests/temporary_folder.hpp"

#ifndef _WIN32  // it has no terminals that a program can pretend to be
#include <fcntl.h>
#include <unistd.h>

using namespace lt::test;

namespace {

// Standard error goes to another file while this lives.
class Redirected {
 public:
  explicit Redirected(int file) : before_(dup(2)) { dup2(file, 2); }
  ~Redirected() {
    dup2(before_, 2);
    close(before_);
  }
  Redirected(const Redirected&) = delete;
  Redirected& operator=(const Redirected&) = delete;

 private:
  int before_;
};

// What `work` writes to a standard error that is a file.
template <class Work>
std::string in_a_file(const Work& work) {
  const TemporaryFolder folder;
  const int file = open((folder / "err").c_str(), O_WRONLY | O_CREAT, 0600);
  REQUIRE(file >= 0);
  {
    const Redirected redirected(file);
    work();
  }
  close(file);
  return get(folder / "err");
}

// What `work` writes to a standard error that is a terminal.
template <class Work>
std::string on_a_terminal(const Work& work) {
  const int screen = posix_openpt(O_RDWR | O_NOCTTY);
  REQUIRE(screen >= 0);
  REQUIRE(grantpt(screen) == 0);
  REQUIRE(unlockpt(screen) == 0);
  const int program = open(ptsname(screen), O_RDWR | O_NOCTTY);
  REQUIRE(program >= 0);
  setenv("TERM", "xterm", 1);
  std::string seen;
  std::thread reader([&] {  // until nobody has the terminal open any more
    char buffer[1024];
    for (ssize_t n; (n = read(screen, buffer, sizeof buffer)) > 0;)
      seen.append(buffer, static_cast<std::size_t>(n));
  });
  {
    const Redirected redirected(program);
    work();
  }
  close(program);
  reader.join();
  close(screen);
  return seen;
}

auto count(const std::string& text, char c) {
  return std::count(text.begin(), text.end(), c);
}

}  // namespace

TEST_CASE("progress: elsewhere than on a terminal a quick job writes one plain line") {
  const std::string text = in_a_file([] {
    lt::Progress progress("room normals", 1000);
    for (int i = 0; i < 1000; ++i)
      progress.advance();
  });
  INFO(text);
  CHECK(text.rfind("room normals: done in ", 0) == 0);
  CHECK(count(text, '\n') == 1);
  CHECK(count(text, '\r') == 0);
}

TEST_CASE("progress: several threads that advance make one last line") {
  const std::string text = in_a_file([] {
    lt::Progress progress("room", 40'000);
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
      threads.emplace_back([&] {
        for (int i = 0; i < 10'000; ++i)
          progress.advance();
      });
    for (std::thread& thread : threads)
      thread.join();
  });
  CHECK(count(text, '\n') == 1);
  CHECK(contains(text, "done in"));
}

TEST_CASE("progress: a job that stops early says so") {
  const std::string text = in_a_file([] {
    lt::Progress progress("room", 4);
    progress.advance();
  });
  CHECK(contains(text, "room: stopped at 25 % after "));
}

TEST_CASE("progress: a terminal shows a bar with the time left, and ends with a clean line") {
  const std::string text = on_a_terminal([] {
    lt::Progress progress("room", 4);
    std::this_thread::sleep_for(std::chrono::milliseconds(120));
    progress.advance();
    progress.advance(3);
  });
  INFO(text);
  CHECK(contains(text, "\rroom: [........................] 0 %"));
  CHECK(contains(text, "\rroom: [######..................] 25 %, "));
  CHECK(contains(text, " left"));
  CHECK(contains(text, "\rroom: done in 0."));
  CHECK(text.substr(text.size() - 2) == "\r\n");
  CHECK(count(text, '\n') == 1);
}

TEST_CASE("progress: a terminal is redrawn a few times, not at every step") {
  const std::string text = on_a_terminal([] {
    lt::Progress progress(std::string(200, 'x'), 20'000);
    for (int i = 0; i < 20'000; ++i)
      progress.advance();
  });
  CHECK(count(text, '\r') < 40);
  // A long label is cut, so that the line does not wrap.
  std::size_t longest = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\r', at), text.size());
    longest = std::max(longest, end - at);
    at = end + 1;
  }
  CHECK(longest < 80);
}

#endif
