/// @file
/// The words behind a command. A command takes what it knows; what is left over is a mistake.
#pragma once

#include <string>
#include <vector>

namespace lt {

/// The words behind `./learn COMMAND`.
class Arguments {
 public:
  Arguments(std::string command, std::vector<std::string> words);

  /// Takes `name` ("--quick") out; true if it was there.
  [[nodiscard]] bool flag(const std::string& name);

  /// Takes `name` and the whole number behind it ("--count 20" or "--count=20") out.
  /// @throws InputError  no number from low to high follows
  [[nodiscard]] int number(const std::string& name, int otherwise, int low, int high);

  /// Takes everything behind "--" out.
  [[nodiscard]] std::vector<std::string> after_dashes();

  /// Everything that is left, options included: for a program that reads them itself.
  [[nodiscard]] std::vector<std::string> all_left();

  /// The words that are left. Call it last.
  /// @param at_most  how many there may be
  /// @throws InputError  an option is left, or more words
  [[nodiscard]] std::vector<std::string> words(std::size_t at_most);

  /// @throws InputError  anything is left
  void nothing_more() { (void)words(0); }

  /// The single word that is left, or "" if there is none.
  [[nodiscard]] std::string word_or_nothing();

 private:
  std::string command_;
  std::vector<std::string> words_;
  std::vector<std::string> known_;
};

}  // namespace lt
