#include "runner/json_files.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "common/error.hpp"
#include "common/pixel_io.hpp"
#include "runner/pattern.hpp"
#include "runner/text.hpp"

namespace lt {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

// Reads the keys of one JSON object and, at the end, refuses those that nobody asked for, so that
// a misspelled key is found. Every complaint is one line: file, place, what is expected.
class Reader {
 public:
  Reader(const json& object, std::string place) : object_(object), place_(std::move(place)) {
    if (!object.is_object()) fail("must be an object {...}");
  }

  std::string text(const std::string& key) {
    const json& value = get(key);
    if (!value.is_string() || trimmed(value.get<std::string>()).empty()) {
      fail("\"" + key + "\" must be a text that is not empty");
    }
    return value.get<std::string>();
  }

  // A text that may be empty.
  std::string any_text(const std::string& key) {
    const json& value = get(key);
    if (!value.is_string()) fail("\"" + key + "\" must be a text");
    return value.get<std::string>();
  }

  int number(const std::string& key, int low, int high) {
    const json& value = get(key);
    if (!value.is_number_integer() || value < low || value > high) {
      fail("\"" + key + "\" must be a whole number from " + std::to_string(low) + " to " +
           std::to_string(high));
    }
    return value.get<int>();
  }

  std::vector<std::string> texts(const std::string& key) {
    std::vector<std::string> values;
    for (const json& item : list(key)) {
      if (!item.is_string()) fail("\"" + key + "\" must be a list of texts");
      values.push_back(item.get<std::string>());
    }
    return values;
  }

  const json& list(const std::string& key) {
    const json& value = get(key);
    if (!value.is_array()) fail("\"" + key + "\" must be a list [...]");
    return value;
  }

  [[nodiscard]] bool has(const std::string& key) const { return object_.contains(key); }

  const json& get(const std::string& key) {
    known_.insert(key);
    if (!object_.contains(key)) fail("\"" + key + "\" is missing");
    return object_[key];
  }

  void refuse_unknown_keys() const {
    for (const auto& [key, value] : object_.items()) {
      if (!known_.contains(key)) {
        fail("nobody knows the key \"" + key + "\"" +
             did_you_mean(key, std::vector<std::string>(known_.begin(), known_.end())));
      }
    }
  }

  [[noreturn]] void fail(const std::string& what) const { throw InputError(place_ + ": " + what); }

 private:
  const json& object_;
  std::string place_;
  std::set<std::string> known_;
};

json parse(std::string_view text, const std::string& place) {
  try {
    return json::parse(text);
  } catch (const json::exception& error) {
    // "[json.exception.parse_error.101] parse error at line 3, column 1: ..." without its number
    const std::string what = error.what();
    throw InputError(place + ": " + what.substr(std::min(what.find("] ") + 2, what.size())));
  }
}

Mutant parse_mutant(const json& object, const std::string& place) {
  Reader reader(object, place);
  Mutant mutant{reader.text("tag"), reader.text("find"), reader.any_text("replace"),
                reader.text("says")};
  reader.refuse_unknown_keys();
  if (!Pattern("[a-z0-9]+(-[a-z0-9]+)*").match(mutant.tag)) {
    reader.fail("\"tag\" must be lower-case-with-dashes");
  }
  if (mutant.find == mutant.replace) reader.fail("\"replace\" must differ from \"find\"");
  return mutant;
}

void check_place(const Reader& reader, const Exercise& exercise) {
  if (!Pattern("[0-9]{2}\\.[0-9]+").match(exercise.id)) {
    reader.fail("\"id\" must be chapter.number as in 02.1");
  }
  if (exercise.name != exercise.folder.filename()) {
    reader.fail("\"name\" must be the folder's name, " + exercise.folder.filename().string());
  }
  if (exercise.chapter != exercise.folder.parent_path().filename()) {
    reader.fail("\"chapter\" must be the chapter's folder, " +
                exercise.folder.parent_path().filename().string());
  }
  if (!exercise.chapter.starts_with("ch" + exercise.id.substr(0, 2) + "_")) {
    reader.fail("\"id\" must begin with the number of " + exercise.chapter);
  }
}

PictureSize parse_size(const json& object, const std::string& place, PictureSize otherwise) {
  Reader reader(object, place);
  if (reader.has("width")) otherwise.width = reader.number("width", 1, max_image_side);
  if (reader.has("height")) otherwise.height = reader.number("height", 1, max_image_side);
  return otherwise;
}

Picture parse_picture(const json& object, const std::string& place) {
  Reader reader(object, place);
  Picture picture;
  picture.file = reader.text("file");
  picture.caption = reader.text("caption");
  picture.args = reader.texts("args");
  if (reader.has("title")) picture.title = reader.text("title");
  for (const char* key : {"width", "height"}) {
    if (reader.has(key)) (void)reader.get(key);
  }
  picture.full = parse_size(object, place, picture.full);
  if (reader.has("stored")) {
    const json& stored = reader.get("stored");
    picture.is_stored = true;
    Reader size(stored, place + ": stored");
    if (!stored.empty()) {
      picture.stored = PictureSize{size.number("width", 1, max_image_side),
                                   size.number("height", 1, max_image_side)};
    }
    size.refuse_unknown_keys();
  }
  reader.refuse_unknown_keys();
  if (!Pattern("[A-Za-z0-9_-]+\\.(png|svg|pfm|csv)").match(picture.file)) {
    reader.fail("\"file\" must be a plain name that ends in .png, .svg, .pfm or .csv");
  }
  return picture;
}

}  // namespace

Exercise parse_exercise(std::string_view text, const fs::path& file) {
  const std::string place = shown_path(file);
  const json object = parse(text, place);
  Reader reader(object, place);
  Exercise exercise;
  exercise.folder = file.parent_path();
  exercise.id = reader.text("id");
  exercise.name = reader.text("name");
  exercise.title = reader.text("title");
  exercise.chapter = reader.text("chapter");
  exercise.minutes = reader.number("minutes", 1, 240);
  exercise.hints = reader.texts("hints");
  check_place(reader, exercise);

  const bool has_empty_hint = std::any_of(exercise.hints.begin(), exercise.hints.end(),
                                          [](const auto& hint) { return trimmed(hint).empty(); });
  if (exercise.hints.size() != 3 || has_empty_hint) reader.fail("\"hints\" must be three texts");

  std::set<std::string> tags;
  for (const json& item : reader.list("mutants")) {
    const std::string number = std::to_string(exercise.mutants.size() + 1);
    exercise.mutants.push_back(parse_mutant(item, place + ": mutant " + number));
    if (!tags.insert(exercise.mutants.back().tag).second) {
      reader.fail("the tag \"" + exercise.mutants.back().tag + "\" is used twice");
    }
  }
  if (exercise.mutants.size() < 2) reader.fail("\"mutants\" must be at least two");
  reader.refuse_unknown_keys();
  return exercise;
}

std::optional<LearnerProgress> parse_progress(std::string_view text) {
  try {
    const json object = json::parse(text);
    LearnerProgress progress;
    progress.current = object.at("current").get<std::string>();
    for (const auto& [id, item] : object.at("exercises").items()) {
      Record record;
      record.is_done = item.at("done").get<bool>();
      record.answer = item.at("answer").get<std::string>();
      record.test = item.at("test").get<std::string>();
      record.kept = item.at("kept").get<std::string>();
      record.hints = std::clamp(item.at("hints").get<int>(), 0, 3);
      progress.records[id] = record;
    }
    return progress;
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

std::string to_json(const LearnerProgress& progress) {
  json exercises = json::object();
  for (const auto& [id, record] : progress.records) {
    exercises[id] = {{"done", record.is_done},
                     {"answer", record.answer},
                     {"test", record.test},
                     {"kept", record.kept},
                     {"hints", record.hints}};
  }
  const json object = {{"current", progress.current}, {"exercises", exercises}};
  return object.dump(2, ' ', true, json::error_handler_t::replace) + "\n";
}

std::vector<Picture> parse_pictures(std::string_view text, const std::string& chapter,
                                    const fs::path& file) {
  const std::string place = shown_path(file);
  const json list = parse(text, place);
  if (!list.is_array()) throw InputError(place + ": must be a list [...] of pictures");
  std::vector<Picture> pictures;
  std::set<std::string> files;
  for (const json& item : list) {
    const std::string number = std::to_string(pictures.size() + 1);
    pictures.push_back(parse_picture(item, place + ": picture " + number));
    pictures.back().chapter = chapter;
    if (!files.insert(pictures.back().file).second) {
      throw InputError(place + ": the file " + pictures.back().file + " is there twice");
    }
  }
  return pictures;
}

}  // namespace lt
