/// @file
/// Options of the chapters' programs. CLI11 stays in command_line.cpp: it is slow to compile.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace lt {

/// The options of one program. Add them, then call parse().
class CommandLine {
 public:
  /// @param program      name shown in messages, e.g. "ch02_ray_casting"
  /// @param description  one sentence for --help
  CommandLine(std::string program, std::string description);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// Names are long options with their dashes: "--width". `value` holds the default before
  /// parse() and the person's choice after it; ranges include both ends.
  void add_int(const std::string& name, int& value, int low, int high, const std::string& help);
  void add_float(const std::string& name, float& value, float low, float high,
                 const std::string& help);
  void add_seed(const std::string& name, std::uint64_t& value, const std::string& help);
  void add_flag(const std::string& name, bool& value, const std::string& help);
  void add_choice(const std::string& name, std::string& value,
                  const std::vector<std::string>& choices, const std::string& help);
  void add_path(const std::string& name, std::filesystem::path& value, const std::string& help);

  /// Says that an option is used only where another has one of these values. parse() then refuses
  /// it elsewhere: an option that changes nothing would be a riddle.
  /// @param name     an option added before
  /// @param other    a choice added before, e.g. "--view"
  /// @param choices  values of `other`
  void only_for(const std::string& name, const std::string& other,
                const std::vector<std::string>& choices);

  /// Says that an option means nothing unless another is given, too; parse() then refuses it.
  void needs(const std::string& name, const std::string& other) { only_for(name, other, {}); }

  /// @return false if --help was asked for and has been printed: end with exit code 0
  /// @throws InputError  an option is unknown, lacks its value, is out of range, or is not used
  ///                     with the others; the line names the option and the remedy
  [[nodiscard]] bool parse(int argc, const char* const* argv);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// What most programs ask for.
struct RenderOptions {
  int width = 900;            ///< pixels, 1 to max_image_side
  int height = 720;           ///< pixels, 1 to max_image_side
  int samples_per_pixel = 1;  ///< 1 to 1,000,000
  std::uint64_t seed = 1;     ///< the picture is a function of its seed
  int threads = 0;            ///< 0: one for each processor
  std::filesystem::path out;  ///< .png for people, .pfm for linear data
};

/// Adds --width, --height and --out.
void add_picture_options(CommandLine& line, RenderOptions& options);

/// Adds --spp, --seed and --threads.
void add_sampling_options(CommandLine& line, RenderOptions& options);

/// Runs a program's body and turns what it throws into one line on stderr and an exit code:
/// InputError 2, anything else 1.
/// @param program  name at the start of the line
[[nodiscard]] int run_program(const std::string& program, const std::function<void()>& body);

}  // namespace lt
