#include "runner/arguments.hpp"

#include <algorithm>
#include <charconv>

#include "common/error.hpp"
#include "common/files.hpp"
#include "runner/text.hpp"

namespace lt {

Arguments::Arguments(std::string command, std::vector<std::string> words)
    : command_(std::move(command)), words_(std::move(words)) {}

bool Arguments::flag(const std::string& name) {
  known_.push_back(name);
  return std::erase(words_, name) > 0;
}

int Arguments::number(const std::string& name, int otherwise, int low, int high) {
  known_.push_back(name);
  const auto found = std::find_if(words_.begin(), words_.end(), [&](const std::string& word) {
    return word == name || word.starts_with(name + "=");
  });
  if (found == words_.end()) return otherwise;
  std::string text = found->size() > name.size() ? found->substr(name.size() + 1) : "";
  auto next = found + 1;
  if (*found == name && next != words_.end()) text = *next++;

  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < low || value > high) {
    throw InputError(name + " takes a whole number from " + std::to_string(low) + " to " +
                     std::to_string(high) + ", not \"" + printable(text) + "\"");
  }
  words_.erase(found, next);
  return value;
}

std::vector<std::string> Arguments::after_dashes() {
  const auto dashes = std::find(words_.begin(), words_.end(), "--");
  if (dashes == words_.end()) return {};
  std::vector<std::string> rest(dashes + 1, words_.end());
  words_.erase(dashes, words_.end());
  return rest;
}

std::vector<std::string> Arguments::all_left() {
  return std::move(words_);
}

std::vector<std::string> Arguments::words(std::size_t at_most) {
  for (const std::string& word : words_) {
    if (word.starts_with("-") && word.size() > 1) {
      throw InputError(command_ + " has no option " + printable(word) +
                       did_you_mean(word, known_, "see ./learn help " + command_));
    }
  }
  if (words_.size() > at_most) {
    throw InputError(command_ + " takes " + (at_most == 0 ? "nothing" : "no more") +
                     " after it: \"" + printable(words_[at_most]) +
                     "\" is too much; see ./learn help " + command_);
  }
  return words_;
}

std::string Arguments::word_or_nothing() {
  const std::vector<std::string> left = words(1);
  return left.empty() ? "" : left.front();
}

}  // namespace lt
