#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <sstream>

#include "common/error.hpp"
#include "runner/process.hpp"

extern char** environ;

namespace lt {

namespace {

using Clock = std::chrono::steady_clock;

std::atomic<bool> is_interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free);  // or a signal handler must not set it

void note_interrupt(int) {
  is_interrupted = true;
}

// What execvp wants: pointers into strings that outlive them.
std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> list;
  for (std::string& word : words)
    list.push_back(word.data());
  list.push_back(nullptr);
  return list;
}

std::vector<std::string> environment_with(const ProcessOptions& options) {
  std::vector<std::string> entries;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string name(*entry, std::strcspn(*entry, "="));
    const bool is_replaced = std::any_of(options.environment.begin(), options.environment.end(),
                                         [&](const auto& pair) { return pair.first == name; });
    if (!is_replaced) entries.emplace_back(*entry);
  }
  for (const auto& [name, value] : options.environment)
    entries.push_back(name + "=" + value);
  return entries;
}

void limit_resources() {
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const rlimit memory{rlim_t{4} << 30, rlim_t{4} << 30};
  setrlimit(RLIMIT_AS, &memory);
}

// Starts the program; with an `output` pipe end it gets a process group of its own, so that it and
// all that it starts can be stopped together.
pid_t start(const std::vector<std::string>& command, const ProcessOptions& options, int output) {
  std::vector<std::string> words = command;
  std::vector<std::string> entries = environment_with(options);
  const std::vector<char*> arguments = pointers(words);
  const std::vector<char*> variables = pointers(entries);
  const std::string folder = options.folder.string();

  const pid_t child = fork();
  if (child < 0) throw OutputError(command[0] + ": cannot start: " + std::strerror(errno));
  if (child > 0) return child;

  // Only async-signal-safe calls from here on.
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  std::signal(SIGHUP, SIG_DFL);
  std::signal(SIGPIPE, SIG_DFL);
  if (output >= 0) {
    setpgid(0, 0);
    dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
  }
  if (options.is_limited) limit_resources();
  if (!folder.empty() && chdir(folder.c_str()) != 0) _exit(126);
  environ = const_cast<char**>(variables.data());
  execvp(arguments[0], arguments.data());
  _exit(127);
}

// The program and the end of a pipe that reads what it prints.
std::pair<pid_t, int> start_with_pipe(const std::vector<std::string>& command,
                                      const ProcessOptions& options) {
  // A program that another thread starts now must not inherit our pipe: we would wait for it too.
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  int ends[2];
  if (pipe(ends) != 0)
    throw OutputError(std::string("cannot open a pipe: ") + std::strerror(errno));
  fcntl(ends[0], F_SETFD, FD_CLOEXEC);
  fcntl(ends[1], F_SETFD, FD_CLOEXEC);
  const pid_t child = start(command, options, ends[1]);
  setpgid(child, child);
  close(ends[1]);
  return {child, ends[0]};
}

void wait_for(pid_t child, ProcessResult& result) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
}

// Reads until the other end is closed; false if the time is over or the person interrupted.
bool read_output(int input, const ProcessOptions& options, Clock::time_point deadline,
                 ProcessResult& result) {
  constexpr std::size_t limit = 4'000'000;
  std::vector<char> buffer(65536);
  while (true) {
    if (is_interrupted) return false;
    if (options.seconds > 0 && Clock::now() > deadline) {
      result.timed_out = true;
      return false;
    }
    pollfd waiting{input, POLLIN, 0};
    if (poll(&waiting, 1, 20) <= 0) continue;
    const ssize_t size = read(input, buffer.data(), buffer.size());
    if (size < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (size <= 0) return true;
    const std::string_view piece(buffer.data(), static_cast<std::size_t>(size));
    result.output += piece.substr(0, limit - std::min(limit, result.output.size()));
    if (options.on_output) options.on_output(piece);
  }
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& command, const ProcessOptions& options) {
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(options.seconds));
  const auto [child, output] = start_with_pipe(command, options);
  ProcessResult result;
  if (!read_output(output, options, deadline, result)) kill(-child, SIGKILL);
  close(output);
  wait_for(child, result);
  if (is_interrupted) throw Interrupted();
  return result;
}

ProcessResult run_visibly(const std::vector<std::string>& command, const ProcessOptions& options) {
  ProcessResult result;
  wait_for(start(command, options, -1), result);
  if (is_interrupted || result.signal == SIGINT) throw Interrupted();
  return result;
}

bool program_exists(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (access((folder + "/" + name).c_str(), X_OK) == 0) return true;
  }
  return false;
}

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = note_interrupt;  // no SA_RESTART: a waiting read() must end
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGHUP, &action, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
}

bool was_interrupted() {
  return is_interrupted.exchange(false);
}

FileLock::FileLock(const std::filesystem::path& path) {
  std::error_code ignored;
  std::filesystem::create_directories(path.parent_path(), ignored);
  handle_ = open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666);
  while (handle_ >= 0 && flock(static_cast<int>(handle_), LOCK_EX) != 0 && errno == EINTR) {
    if (was_interrupted()) throw Interrupted();
  }
}

FileLock::~FileLock() {
  if (handle_ >= 0) close(static_cast<int>(handle_));
}

}  // namespace lt
