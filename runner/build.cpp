#include "runner/build.hpp"

#include <iostream>

#include "common/files.hpp"
#include "common/parallel.hpp"
#include "runner/pattern.hpp"
#include "runner/terminal.hpp"
#include "runner/text.hpp"

namespace lt {

namespace fs = std::filesystem;

namespace {

// Compilers speak English with plain quotes, so that their errors can be read.
ProcessOptions plain_english() {
  ProcessOptions options;
  options.environment = {{"LC_ALL", "C"}};
  return options;
}

// A line that overwrites itself while Ninja ("[3/40]") or Make ("[ 12%]") count; on no terminal
// only its label.
class BuildLine {
 public:
  BuildLine(std::string label, bool is_quiet) : label_(std::move(label)) {
    if (is_quiet) return;
    std::cerr << label_ << " ..." << std::flush;
    if (!stderr_is_terminal()) std::cerr << std::endl;
    is_shown_ = stderr_is_terminal();
  }
  ~BuildLine() {
    if (is_shown_) std::cerr << "\r\x1b[K" << std::flush;
  }
  BuildLine(const BuildLine&) = delete;
  BuildLine& operator=(const BuildLine&) = delete;

  void show(std::string_view piece) {
    static const Pattern count(R"(\[ *(\d+/\d+|\d+%)\])");
    if (!stderr_is_terminal()) return;
    std::string latest;
    for (const std::string& line : split_lines(piece)) {
      if (const auto found = count.search(line)) latest = (*found)[1];
    }
    if (latest.empty()) return;
    std::cerr << '\r' << label_ << " [" << latest << "]\x1b[K" << std::flush;
    is_shown_ = true;
  }

 private:
  std::string label_;
  bool is_shown_ = false;
};

// A build folder that was made elsewhere (the repository has moved, or a container shares it)
// cannot be used.
void forget_if_moved(const fs::path& source, const fs::path& binary) {
  const fs::path cache = binary / "CMakeCache.txt";
  if (!fs::exists(cache)) return;
  static const Pattern home(R"(CMAKE_HOME_DIRECTORY:INTERNAL=([^\r\n]*))");
  const std::string text = read_file(cache);
  std::error_code ignored;
  const auto made_for = home.search(text);
  if (made_for && fs::equivalent((*made_for)[1], source, ignored)) return;
  std::cerr << shown_path(binary) << " was made for another folder: making it anew" << std::endl;
  fs::remove_all(binary);
}

ProcessResult run_with_line(const std::vector<std::string>& command, ProcessOptions options,
                            const std::string& label, bool is_quiet) {
  BuildLine line(label, is_quiet);
  options.on_output = [&](std::string_view piece) { line.show(piece); };
  ProcessResult result = run_process(command, options);
  if (result.exit_code == 127) throw BuildFailed("cmake is not there; see ./learn doctor\n");
  return result;
}

void run_or_fail(const std::vector<std::string>& command, const ProcessOptions& options,
                 const std::string& label) {
  const ProcessResult result = run_with_line(command, options, label, false);
  if (!result.succeeded()) throw BuildFailed(result.output);
}

bool is_configured(const fs::path& binary) {
  const auto has = [&](const char* name) { return fs::exists(binary / name); };
  return has("build.ninja") || has("Makefile") || has("ALL_BUILD.vcxproj");
}

// Ninja where it is. On Windows CMake chooses: Visual Studio finds its compiler in any terminal,
// Ninja does not.
std::vector<std::string> generator(const fs::path& binary) {
#ifdef _WIN32
  constexpr bool is_windows = true;
#else
  constexpr bool is_windows = false;
#endif
  if (is_windows || fs::exists(binary / "CMakeCache.txt") || !program_exists("ninja")) return {};
  return {"-G", "Ninja"};
}

// Visual Studio builds every configuration in one folder, and Debug unless told; others ignore it.
std::vector<std::string> build_command(const fs::path& binary) {
  return {"cmake",
          "--build",
          binary.string(),
          "--config",
          "Release",
          "--parallel",
          std::to_string(thread_count(0))};
}

void append(std::vector<std::string>& words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
}

// Written behind a successful configure: with which settings.
fs::path settings_file(const fs::path& binary) {
  return binary / "lt-settings.txt";
}

}  // namespace

void configure(const Home& home, const std::string& preset) {
  const fs::path binary = home.build(preset);
  forget_if_moved(home.root, binary);
  if (is_configured(binary)) return;
  std::vector<std::string> command{"cmake", "--preset", preset};
  append(command, generator(binary));
  ProcessOptions options = plain_english();
  options.folder = home.root;
  run_or_fail(command, options, "configuring " + shown_path(binary));
}

void configure_folder(const fs::path& source, const fs::path& binary,
                      const std::vector<std::string>& settings) {
  forget_if_moved(source, binary);
  const std::string wanted = join(settings, "\n") + "\n";
  if (is_configured(binary) && fs::exists(settings_file(binary)) &&
      read_file(settings_file(binary)) == wanted) {
    return;
  }
  std::vector<std::string> command{"cmake", "-S", source.string(), "-B", binary.string()};
  append(command, generator(binary));
  append(command, settings);
  run_or_fail(command, plain_english(), "preparing " + shown_path(binary));
  write_file_whole(settings_file(binary), wanted);
}

void build(const fs::path& binary, const std::vector<std::string>& targets,
           const std::string& label) {
  std::vector<std::string> command = build_command(binary);
  if (!targets.empty()) {
    command.push_back("--target");
    append(command, targets);
  }
  run_or_fail(command, plain_english(), label);
}

ProcessResult try_build(const fs::path& binary, const std::string& target,
                        const std::string& label) {
  std::vector<std::string> command = build_command(binary);
  append(command, {"--target", target});
  return run_with_line(command, plain_english(), label, true);
}

fs::path built_program(const fs::path& folder, const std::string& name) {
  for (const char* configuration : {"", "Release", "Debug"}) {
    for (const char* suffix : {"", ".exe"}) {
      const fs::path program = folder / configuration / (name + suffix);
      if (fs::is_regular_file(program)) return program;
    }
  }
  throw BuildFailed(shown_path(folder / name) + " has not been built");
}

}  // namespace lt
