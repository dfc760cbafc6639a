#include "runner/json_files.hpp"

#include "common/error.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

const std::string valid = R"({
  "id": "02.2", "name": "sphere", "title": "Hit a sphere", "chapter": "ch02_ray_casting",
  "minutes": 20, "hints": ["one?", "two?", "three?"],
  "mutants": [
    {"tag": "near-root-only", "find": "a", "replace": "b", "says": "From inside: nothing."},
    {"tag": "assumes-unit-d", "find": "c", "replace": "", "says": "Long rays are wrong."}]
})";

const std::filesystem::path place = "exercises/ch02_ray_casting/sphere/exercise.json";

// What the reader says about the valid text with one part replaced.
std::string complaint_about(const std::string& part, const std::string& with) {
  std::string text = valid;
  const std::size_t at = text.find(part);
  REQUIRE(at != std::string::npos);
  text.replace(at, part.size(), with);
  try {
    (void)parse_exercise(text, place);
  } catch (const InputError& error) {
    const std::string message = error.what();
    CHECK(message.find("sphere/exercise.json") != std::string::npos);
    CHECK(message.find('\n') == std::string::npos);
    return message;
  }
  return "no complaint";
}

bool says(const std::string& message, const std::string& part) {
  INFO(message);
  return message.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("exercise.json: everything that is written is read") {
  const Exercise exercise = parse_exercise(valid, place);
  CHECK(exercise.id == "02.2");
  CHECK(exercise.file_name() == "02.2-sphere.cpp");
  CHECK(exercise.minutes == 20);
  CHECK(exercise.hints.size() == 3);
  REQUIRE(exercise.mutant("assumes-unit-d") != nullptr);
  CHECK(exercise.mutant("assumes-unit-d")->replace.empty());
  CHECK(exercise.mutant("nobody") == nullptr);
}

TEST_CASE("exercise.json: every mistake is told in one line that names it") {
  CHECK(says(complaint_about("\"id\": \"02.2\"", "\"id\": \"2.2\""), "chapter.number"));
  CHECK(says(complaint_about("\"id\": \"02.2\"", "\"id\": \"03.2\""), "begin with the number"));
  CHECK(says(complaint_about("\"sphere\"", "\"ball\""), "\"name\" must be the folder's name"));
  CHECK(says(complaint_about("\"ch02_ray_casting\"", "\"ch02\""), "\"chapter\" must be"));
  CHECK(says(complaint_about("\"Hit a sphere\"", "\" \""), "\"title\""));
  CHECK(says(complaint_about("20", "0"), "\"minutes\" must be a whole number"));
  CHECK(says(complaint_about("20", "\"20\""), "\"minutes\""));
  CHECK(says(complaint_about("20", "1e9"), "\"minutes\""));
  CHECK(says(complaint_about("\"three?\"", "\"\""), "\"hints\" must be three texts"));
  CHECK(says(complaint_about(", \"three?\"", ""), "\"hints\" must be three texts"));
  CHECK(says(complaint_about("\"three?\"", "3"), "\"hints\" must be a list of texts"));
  CHECK(says(complaint_about("[\"one?\", \"two?\", \"three?\"]", "\"one?\""), "list"));
  CHECK(says(complaint_about("assumes-unit-d", "near-root-only"), "is used twice"));
  CHECK(says(complaint_about("assumes-unit-d", "Assumes unit"), "lower-case-with-dashes"));
  CHECK(says(complaint_about("\"replace\": \"b\"", "\"replace\": \"a\""), "must differ"));
  CHECK(says(complaint_about("\"says\": \"From", "\"say\": \"From"), "\"says\" is missing"));
  CHECK(says(complaint_about("\"minutes\"", "\"hnits\": 1, \"minutes\""), "\"hnits\""));
  CHECK(says(complaint_about("\"hints\":", "\"hint\":"), "\"hints\" is missing"));
}

TEST_CASE("exercise.json: text that is no JSON is told with its line") {
  CHECK(says(complaint_about("\"minutes\": 20,", "\"minutes\": 20"), "line 3"));
  for (const std::string& text :
       {std::string(), std::string("[]"), std::string("null"), std::string("{"),
        std::string(100'000, '['), std::string("\xff\xfe"), std::string("{\"id\": {}}")}) {
    CHECK_THROWS_AS(parse_exercise(text, place), InputError);
  }
}

TEST_CASE("progress: what was written is read again") {
  LearnerProgress progress;
  progress.current = "02.2";
  progress.records["02.2"] = {true, "a1", "b2", "c3", 2};
  const auto read = parse_progress(to_json(progress));
  REQUIRE(read);
  CHECK(read->current == "02.2");
  REQUIRE(read->records.contains("02.2"));
  const Record& record = read->records.at("02.2");
  CHECK(record.is_done);
  CHECK(record.answer == "a1");
  CHECK(record.test == "b2");
  CHECK(record.kept == "c3");
  CHECK(record.hints == 2);
}

TEST_CASE("progress: hostile content is no progress file and no crash") {
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("[]"), std::string("null"), std::string("42"),
        std::string("{\"current\": 1, \"exercises\": {}}"), std::string("{\"current\": \"x\"}"),
        std::string("{\"current\": \"x\", \"exercises\": []}").replace(29, 2, "{\"a\": 3}"),
        std::string("{\"current\": \"x\", \"exercises\": {\"a\": {\"done\": \"yes\"}}}"),
        std::string(200'000, '['), std::string("\0\xff", 2),
        std::string("{\"current\": \"\xff\"}")}) {
    CHECK_FALSE(parse_progress(text));
  }
}

TEST_CASE("progress: numbers out of range are pulled in") {
  const auto read = parse_progress(
      R"({"current": "", "exercises": {"a": {"done": false, "answer": "", "test": "", "kept": "",
          "hints": 999999999}}})");
  REQUIRE(read);
  CHECK(read->records.at("a").hints == 3);
}

TEST_CASE("pictures.json: sizes, and what is left out") {
  const auto pictures = parse_pictures(
      R"([{"file": "a.png", "caption": "A.", "args": ["--view", "n"],
           "stored": {"width": 480, "height": 384}},
          {"file": "b.svg", "caption": "B.", "args": [], "stored": {}},
          {"file": "c.png", "caption": "C.", "args": [], "width": 300, "height": 200}])",
      "ch02_ray_casting", "pictures.json");
  REQUIRE(pictures.size() == 3);
  CHECK(pictures[0].full.width == 900);
  CHECK(pictures[0].full.height == 720);
  REQUIRE(pictures[0].stored);
  CHECK(pictures[0].stored->height == 384);
  CHECK(pictures[1].is_stored);
  CHECK_FALSE(pictures[1].stored);
  CHECK_FALSE(pictures[2].is_stored);
  CHECK(pictures[2].full.width == 300);
}

TEST_CASE("pictures.json: mistakes are refused") {
  for (const char* text :
       {"{}", "[1]", R"([{"file": "a.png", "caption": "A."}])",
        R"([{"file": "../a.png", "caption": "A.", "args": []}])",
        R"([{"file": "a.txt", "caption": "A.", "args": []}])",
        R"([{"file": "a.png", "caption": "", "args": []}])",
        R"([{"file": "a.png", "caption": "A.", "args": "--view"}])",
        R"([{"file": "a.png", "caption": "A.", "args": [], "width": 0}])",
        R"([{"file": "a.png", "caption": "A.", "args": [], "stored": {"width": 4}}])",
        R"([{"file": "a.png", "caption": "A.", "args": [], "captoin": "x"}])",
        R"([{"file": "a.png", "caption": "A.", "args": []},
            {"file": "a.png", "caption": "B.", "args": []}])"}) {
    INFO(text);
    CHECK_THROWS_AS(parse_pictures(text, "ch02_ray_casting", "pictures.json"), InputError);
  }
}
