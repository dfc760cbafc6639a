#include "common/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <iostream>
#include <locale>
#include <map>
#include <numeric>
#include <sstream>

#include "common/error.hpp"
#include "common/files.hpp"
#include "common/option_use.hpp"
#include "common/pixel_io.hpp"

namespace lt {

namespace {

// An option with a value. `set` stores the text's value, or returns false if it is none.
struct ValueOption {
  std::string name;
  std::string takes;  // completes "--width takes ..."
  std::function<bool(const std::string&)> set;
};

// The whole of `text` as an integer: no sign but '-', no space, nothing after it.
template <class Integer>
bool parse_integer(const std::string& text, Integer& value) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end;
}

// The whole of `text` as a finite number, with a decimal point in every country.
bool parse_float(const std::string& text, float& value) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  in >> std::noskipws >> value;
  return in && in.peek() == std::istringstream::traits_type::eof() && std::isfinite(value);
}

std::string number(float value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

// Letters to insert, remove or replace to turn a into b (Levenshtein 1965), row by row.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

struct CommandLine::Impl {
  Impl(const std::string& program, const std::string& description) : app(description, program) {
    app.set_help_flag("--help,-h", "print this and end");
  }

  // `shown` stands for the value in --help, `standard` is the value if the option is not given.
  void add(ValueOption option, const std::string& shown, const std::string& standard,
           const std::string& help) {
    const auto set = [option](const std::string& text) {
      if (option.set(text)) return;
      throw InputError(option.name + " takes " + option.takes + ", not \"" + printable(text) +
                       "\"");
    };
    app.add_option_function<std::string>(option.name, set, help)
        ->type_name(shown)
        ->default_str(standard)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    options.push_back(std::move(option));
  }

  // CLI11's complaint in one line of ours.
  [[nodiscard]] std::string explain(const CLI::ParseError& error) const {
    const std::string complaint = printable(error.what());
    for (const ValueOption& option : options)
      if (complaint.starts_with(option.name + ":"))
        return option.name + " takes " + option.takes + "; no value is given";
    for (const std::string& flag : flags)
      if (complaint.starts_with(flag.substr(2) + " ")) return flag + " takes no value";
    const std::vector<std::string> unknown = app.remaining();
    if (unknown.empty()) return complaint + "; --help lists the options";
    return "\"" + printable(unknown.front()) + "\" is no option; " + suggestion(unknown.front());
  }

  [[nodiscard]] std::string suggestion(const std::string& mistyped) const {
    std::string nearest;
    std::size_t least = 3;  // more edits than that are no slip of the finger
    for (const CLI::Option* option : app.get_options()) {
      const std::string name = option->get_name();
      const std::size_t edits = edit_distance(mistyped.substr(0, mistyped.find('=')), name);
      if (edits >= least) continue;
      least = edits;
      nearest = name;
    }
    return (nearest.empty() ? "" : "did you mean " + nearest + "? ") + "--help lists them all";
  }

  void check(const OptionUse& use) const {
    if (app.count(use.name) == 0) return;
    const auto choice = choices.find(use.other);
    require_use(use, app.count(use.other) > 0, choice == choices.end() ? "" : *choice->second);
  }

  CLI::App app;
  std::vector<ValueOption> options;
  std::vector<std::string> flags;
  std::map<std::string, const std::string*> choices;  // by name
  std::vector<OptionUse> uses;
};

CommandLine::CommandLine(std::string program, std::string description)
    : impl_(std::make_unique<Impl>(program, description)) {}

CommandLine::~CommandLine() = default;

void CommandLine::add_int(const std::string& name, int& value, int low, int high,
                          const std::string& help) {
  const auto set = [&value, low, high](const std::string& text) {
    int given = 0;
    if (!parse_integer(text, given) || given < low || given > high) return false;
    value = given;
    return true;
  };
  const std::string from = std::to_string(low);
  const std::string to = std::to_string(high);
  impl_->add({name, "a whole number from " + from + " to " + to, set}, from + ".." + to,
             std::to_string(value), help);
}

void CommandLine::add_float(const std::string& name, float& value, float low, float high,
                            const std::string& help) {
  const auto set = [&value, low, high](const std::string& text) {
    float given = 0;
    if (!parse_float(text, given) || given < low || given > high) return false;
    value = given;
    return true;
  };
  impl_->add({name, "a number from " + number(low) + " to " + number(high), set},
             number(low) + ".." + number(high), number(value), help);
}

void CommandLine::add_seed(const std::string& name, std::uint64_t& value, const std::string& help) {
  const auto set = [&value](const std::string& text) { return parse_integer(text, value); };
  impl_->add({name, "a whole number from 0 to 18446744073709551615", set}, "N",
             std::to_string(value), help);
}

void CommandLine::add_flag(const std::string& name, bool& value, const std::string& help) {
  impl_->app.add_flag(name, value, help)->disable_flag_override();  // no --flat=no
  impl_->flags.push_back(name);
}

void CommandLine::add_choice(const std::string& name, std::string& value,
                             const std::vector<std::string>& choices, const std::string& help) {
  const auto set = [&value, choices](const std::string& text) {
    if (std::find(choices.begin(), choices.end(), text) == choices.end()) return false;
    value = text;
    return true;
  };
  std::string listed;
  std::string shown;
  for (const std::string& choice : choices) {
    listed += (listed.empty() ? "" : ", ") + choice;
    shown += (shown.empty() ? "" : "|") + choice;
  }
  impl_->add({name, "one of " + listed, set}, shown, value, help);
  impl_->choices[name] = &value;
}

void CommandLine::add_path(const std::string& name, std::filesystem::path& value,
                           const std::string& help) {
  const auto set = [&value](const std::string& text) {
    if (text.empty() || text.starts_with("--")) return false;  // the next option, eaten
    value = text;
    return true;
  };
  impl_->add({name, "a path", set}, "PATH", value.string(), help);
}

void CommandLine::only_for(const std::string& name, const std::string& other,
                           const std::vector<std::string>& choices) {
  assert(choices.empty() || impl_->choices.contains(other));
  impl_->uses.push_back({name, other, choices});
}

bool CommandLine::parse(int argc, const char* const* argv) {
  try {
    impl_->app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    std::cout << impl_->app.help();
    return false;
  } catch (const CLI::ParseError& error) {
    throw InputError(impl_->explain(error));
  }
  for (const OptionUse& use : impl_->uses)
    impl_->check(use);
  return true;
}

void add_picture_options(CommandLine& line, RenderOptions& options) {
  line.add_int("--width", options.width, 1, max_image_side, "width of the picture in pixels");
  line.add_int("--height", options.height, 1, max_image_side, "height of the picture in pixels");
  line.add_path("--out", options.out, "file to write: .png for people, .pfm for linear data");
}

void add_sampling_options(CommandLine& line, RenderOptions& options) {
  line.add_int("--spp", options.samples_per_pixel, 1, 1'000'000, "samples per pixel");
  line.add_seed("--seed", options.seed, "the picture is a function of its seed");
  line.add_int("--threads", options.threads, 0, 1024, "threads; 0: one for each processor");
}

int run_program(const std::string& program, const std::function<void()>& body) {
  const auto say = [&program](const char* what) {
    std::cerr << program + ": " + printable(what) + "\n" << std::flush;
  };
  try {
    body();
    return 0;
  } catch (const InputError& error) {
    say(error.what());
    return 2;
  } catch (const std::bad_alloc&) {
    say("not enough memory; ask for less");
    return 1;
  } catch (const std::exception& error) {
    say(error.what());
    return 1;
  }
}

}  // namespace lt
