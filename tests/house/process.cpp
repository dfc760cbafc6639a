#include "tests/house/process.hpp"

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>

#ifndef _WIN32
#include <sys/wait.h>
#endif

namespace lt::house {
namespace {

#ifdef _WIN32
// cmd.exe strips the outermost pair of quotes of the whole line.
std::string quoted(const std::string& word) {
  std::string text = "\"";
  for (const char c : word)
    text += c == '"' ? std::string("\\\"") : std::string(1, c);
  return text + "\"";
}
std::string shell_line(const std::string& line) {
  return "\"" + line + " <NUL\"";
}
constexpr char enter[] = "cd /d ";  // to another drive as well
void end_lines_plainly(std::string& text) {
  std::erase(text, '\r');
}
int exit_code_of(int status) {
  return status;
}
#else
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word)
    text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string shell_line(const std::string& line) {
  return line + " </dev/null";
}
constexpr char enter[] = "cd ";
void end_lines_plainly(std::string&) {}

int exit_code_of(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}
#endif

std::string slurp(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  end_lines_plainly(text);
  return text;
}

}  // namespace

Outcome run(const std::vector<std::string>& command, const std::filesystem::path& folder) {
  const TemporaryFolder streams;
  const std::filesystem::path out = streams.path() / "out";
  const std::filesystem::path err = streams.path() / "err";
  std::string line = folder.empty() ? "" : enter + quoted(folder.string()) + " && ";
  for (const std::string& word : command)
    line += quoted(word) + " ";
  line += ">" + quoted(out.string()) + " 2>" + quoted(err.string());
  const int status = std::system(shell_line(line).c_str());
  return {exit_code_of(status), slurp(out), slurp(err)};
}

TemporaryFolder::TemporaryFolder() {
  std::random_device entropy;
  do {
    const std::uint64_t number = std::uint64_t{entropy()} << 32 | entropy();
    path_ = std::filesystem::temp_directory_path() / ("tracing-light-" + std::to_string(number));
  } while (!std::filesystem::create_directory(path_));
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace lt::house
