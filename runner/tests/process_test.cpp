// Other programs, on every system; the program that is run is runner/tests/child.
#include "runner/process.hpp"

#include <atomic>
#include <chrono>
#include <csignal>
#include <thread>

#include "common/testkit/catch.hpp"
#include "common/tests/temporary_folder.hpp"

using namespace lt;
using lt::test::TemporaryFolder;

namespace {

using Words = std::vector<std::string>;

ProcessResult child(const Words& words, const ProcessOptions& options = {}) {
  Words command{LT_CHILD};
  command.insert(command.end(), words.begin(), words.end());
  return run_process(command, options);
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

TEST_CASE("process: words arrive as they were given") {
  const Words words{"plain",
                    "two words",
                    "",
                    R"("quoted")",
                    R"(a\b)",
                    R"(a\)",
                    R"(a b\)",
                    R"(a\"b\\"c)",
                    R"(\\host\d e)",
                    "$HOME *.cpp %PATH% ^&|"};
  std::string expected;
  for (const std::string& word : words)
    expected += "<" + word + ">\n";
  Words all{"words"};
  all.insert(all.end(), words.begin(), words.end());
  CHECK(child(all).output == expected);
}

TEST_CASE("process: variables are added - the folder is as asked - and the input is empty") {
  ProcessOptions options;
  options.environment = {{"LT_TEST_NAME", "one=two"}, {"PATH", "replaced"}};
  CHECK(child({"variable", "LT_TEST_NAME"}, options).output == "one=two");
  CHECK(child({"variable", "PATH"}, options).output == "replaced");
  CHECK(child({"input"}).output == "0");
}

TEST_CASE("process: both streams come in the order printed - and in pieces") {
  std::string pieces;
  ProcessOptions options;
  options.on_output = [&](std::string_view piece) { pieces += piece; };
  CHECK(child({"both"}, options).output == "out\nerr\n");
  std::erase(pieces, '\r');
  CHECK(pieces == "out\nerr\n");
}

TEST_CASE("process: exit code - crash - and a program that is not there are told apart") {
  CHECK(child({"exit", "0"}).succeeded());
  CHECK(child({"exit", "3"}).exit_code == 3);
  CHECK(child({"exit", "3"}).signal == 0);
  ProcessOptions options;
  options.is_limited = true;
  CHECK(child({"crash"}, options).signal == SIGSEGV);
  CHECK(run_process({"lt-no-such-program"}).exit_code == 127);
  CHECK_FALSE(program_exists("lt-no-such-program"));
}

TEST_CASE("process: when the time is over what the program has started is stopped as well") {
  ProcessOptions options;
  options.seconds = 1;
  const auto start = std::chrono::steady_clock::now();
  const ProcessResult result = child({"parent"}, options);
  CHECK(result.timed_out);
  CHECK_FALSE(result.succeeded());
  CHECK(result.output == "sleeping\n");
  CHECK(seconds_since(start) < 20);  // the sleeper holds the pipe open for 60
}

TEST_CASE("process: threads that run programs at once get the output of their own") {
  std::vector<std::string> outputs(8);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    threads.emplace_back([&outputs, i] {
      outputs[i] = child({"words", std::to_string(i)}).output;
    });
  }
  for (std::thread& thread : threads)
    thread.join();
  for (std::size_t i = 0; i < outputs.size(); ++i)
    CHECK(outputs[i] == "<" + std::to_string(i) + ">\n");
}

TEST_CASE("lock: a second one on the same path waits for the first") {
  const TemporaryFolder folder;
  std::atomic<bool> is_second_in = false;
  std::thread second;
  {
    const FileLock first(folder / "new folder/lock");
    second = std::thread([&] {
      const FileLock lock(folder / "new folder/lock");
      is_second_in = true;
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    CHECK_FALSE(is_second_in);
  }
  second.join();
  CHECK(is_second_in);
}
