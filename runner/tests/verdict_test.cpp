#include <csignal>

#include "common/testkit/catch.hpp"
#include "runner/text.hpp"
#include "runner/verdict.hpp"

using namespace lt;

namespace {

Exercise sphere() {
  Exercise exercise;
  exercise.id = "02.2";
  exercise.name = "sphere";
  exercise.mutants = {{"near-root-only", "a", "b", "From inside you see nothing."}};
  return exercise;
}

const std::string test_cpp =
    "#include \"api.hpp\"\n"
    "TEST_CASE(\"a ray from inside hits\") {\n"
    "  CHECK(t == 2);\n"
    "}\n"
    "TEST_CASE(\"a ray from outside hits\") {\n"
    "  CHECK(t == 3);\n"
    "}\n";

Verdict verdict(const ProcessResult& result, const std::string& report = "") {
  return verdict_on_run(sphere(), result, read_test_output(result.output, report, test_cpp), 10);
}

ProcessResult failed(const std::string& output) {
  ProcessResult result;
  result.exit_code = 1;
  result.output = output;
  return result;
}

}  // namespace

TEST_CASE("verdict: the first TODO is named with its line") {
  const Verdict v =
      verdict(failed("[not-written] /course of a b/my/02.2-sphere.cpp:12: find the root\n"
                     "[not-written] /course of a b/my/02.2-sphere.cpp:20: turn the normal\n"));
  CHECK(v.kind == VerdictKind::not_started);
  CHECK(v.line == 12);
  CHECK(v.says == "find the root");
}

TEST_CASE("verdict: a named mistake gives its sentence and what was seen") {
  const Verdict v = verdict(failed("[diag:near-root-only] no hit, expected t = 1\n"));
  CHECK(v.kind == VerdictKind::not_yet);
  CHECK(v.says == "From inside you see nothing.");
  REQUIRE(v.details.size() == 1);
  CHECK(v.details[0] == "seen: no hit, expected t = 1");
}

TEST_CASE("verdict: only the first of two mistakes is told") {
  const Verdict v = verdict(failed("[diag:near-root-only] one\n[diag:other] two\n"));
  CHECK(v.says == "From inside you see nothing.");
  CHECK(v.details.size() == 1);
}

TEST_CASE("verdict: the mark is found behind the learner's own output on the same line") {
  const Verdict v = verdict(failed("t = 4[diag:near-root-only] no hit\n"));
  CHECK(v.says == "From inside you see nothing.");
}

TEST_CASE("verdict: a tag that nobody described still tells what was seen") {
  CHECK(verdict(failed("[diag:unheard-of] 3 is not 4\n")).says == "3 is not 4");
}

TEST_CASE("verdict: a written mistake before an unwritten body is told first") {
  const Verdict v = verdict(failed("[diag:near-root-only] x\n[not-written] a.cpp:9: rest\n"));
  CHECK(v.kind == VerdictKind::not_yet);
  CHECK(v.says == "From inside you see nothing.");
}

TEST_CASE("verdict: a failing check is told as its test case's sentence with values") {
  const Verdict v = verdict(failed(""),
                            "test.cpp:6: failed: t == Approx(3.0) for: 2.0 == Approx( 3.0 ) with 1 "
                            "message: 'seed 4'\nFailed 1 test case, failed 1 assertion.\n");
  CHECK(v.kind == VerdictKind::not_yet);
  CHECK(v.says.find("a ray from outside hits") != std::string::npos);
  const std::string details = join(v.details, "\n");
  CHECK(details.find("t == Approx(3.0)\n") != std::string::npos);
  CHECK(details.find("2.0 == Approx( 3.0 )\n") != std::string::npos);
  CHECK(details.find("about it: seed 4\n") != std::string::npos);
}

TEST_CASE("verdict: long values, which Catch2 breaks into lines, are told whole") {
  const Verdict v =
      verdict(failed(""),
              "test.cpp:3: failed: f(v) == close_to(w) for: (0.123456789, 0.5, 0.25)\n"
              "==\n"
              "close to (0.987654321, 0.5, 0.25) with 1 message: 'seed 4'\n"
              "test.cpp:6: failed: t == 3 for: 2 == 3\n"
              "Failed 2 test cases, failed 2 assertions.\n");
  CHECK(v.details == std::vector<std::string>{
                         "checked:  f(v) == close_to(w)",
                         "there:    (0.123456789, 0.5, 0.25) == close to (0.987654321, 0.5, 0.25)",
                         "about it: seed 4", "(test.cpp, line 3)"});
}

TEST_CASE("verdict: an exception is told with its words") {
  const Verdict v = verdict(failed(""),
                            "t.cpp:3: failed: unexpected exception with message: "
                            "'vector::at'; expression was: f(1)\n");
  CHECK(join(v.details, "\n").find("an exception came out: vector::at") != std::string::npos);
}

TEST_CASE("verdict: a crash names signal and check in words") {
  ProcessResult result;
  result.signal = SIGSEGV;
  const Verdict v = verdict(result,
                            "test.cpp:3: failed: fatal error condition with message: "
                            "'SIGSEGV - Segmentation violation signal'\n");
  CHECK(v.kind == VerdictKind::not_yet);
  CHECK(v.says.find("memory that is not its own (SIGSEGV)") != std::string::npos);
  CHECK(v.says.find("a ray from inside hits") != std::string::npos);
}

TEST_CASE("verdict: an index out of range is told in words and not printed twice") {
  ProcessResult result;
  result.signal = SIGABRT;
  result.output =
      "hello\n/usr/include/c++/12/bits/stl_vector.h:1142: constexpr const_reference "
      "std::vector<_Tp, _Alloc>::operator[](size_type) const [with _Tp = double; _Alloc = "
      "std::allocator<double>; size_type = long unsigned int]: Assertion '__n < this->size()' "
      "failed.\n";
  const Verdict v = verdict(result);
  CHECK(v.details == std::vector<std::string>{"an index into a std::vector is not less than its "
                                              "size"});
  CHECK(v.printed == std::vector<std::string>{"hello"});
}

TEST_CASE("verdict: another assertion of the library is told from its point on") {
  ProcessResult result;
  result.signal = SIGABRT;
  result.output =
      "/usr/include/c++/12/optional:477: constexpr _Tp& std::optional<_Tp>::_M_get(): Assertion "
      "'this->_M_is_engaged()' failed.\n";
  CHECK(verdict(result).details ==
        std::vector<std::string>{"std::optional: Assertion 'this->_M_is_engaged()' failed."});
  result.output = "prog: a.cpp:3: int f(int): Assertion `x > 0' failed.\n";
  CHECK(verdict(result).details == std::vector<std::string>{"Assertion `x > 0' failed."});
}

TEST_CASE("verdict: time that is over asks for the loop") {
  ProcessResult result;
  result.timed_out = true;
  result.signal = 9;
  CHECK(verdict(result).says.find("still running after 10 s") != std::string::npos);
}

TEST_CASE("verdict: done shows what was measured and the learner's own output") {
  ProcessResult result;
  result.output = "hello\n[measured] 3 roots\n";
  const Verdict v = verdict(result, "Passed all 2 test cases with 2 assertions.\n");
  CHECK(v.kind == VerdictKind::done);
  CHECK(v.measured == std::vector<std::string>{"3 roots"});
  CHECK(v.printed == std::vector<std::string>{"hello"});
}

TEST_CASE("verdict: output that means nothing to us is no crash of ours") {
  for (const std::string& output :
       {std::string("[diag:"), std::string("[diag:]"), std::string("[not-written]"),
        std::string("[not-written] x"), std::string("[not-written] a:99999999999999: x"),
        std::string(100'000, '['), std::string("\0\x1b[31m\xff", 7)}) {
    CHECK(verdict(failed(output)).kind != VerdictKind::done);
  }
}

TEST_CASE("build error: the first one in the learner's file, with its line of code") {
  const std::string gcc =
      "In file included from api.hpp:3,\n"
      "/course/my/02.2-sphere.cpp: In function 'double f(double)':\n"
      "/course/my/02.2-sphere.cpp:7:10: warning: unused variable 'a' [-Wunused-variable]\n"
      "/course/my/02.2-sphere.cpp:8:17: error: 'y' was not declared in this scope\n"
      "    8 |   return x / 2 + y;\n"
      "      |                  ^\n"
      "/course/my/02.2-sphere.cpp:9:1: error: expected '}' at end of input\n";
  const auto error = first_build_error(gcc, "my/02.2-sphere.cpp");
  REQUIRE(error);
  CHECK(error->line == 8);
  CHECK(error->column == 17);
  CHECK(error->message == "'y' was not declared in this scope");
  CHECK(error->location == "  return x / 2 + y;");
}

TEST_CASE("build error: clang and MSVC are read as well") {
  const auto clang = first_build_error(
      "../my/02.2-sphere.cpp:8:10: error: use of undeclared identifier 'y'\n"
      "  return y;\n         ^\n",
      "my/02.2-sphere.cpp");
  REQUIRE(clang);
  CHECK(clang->line == 8);
  CHECK(clang->location == "  return y;");
  const auto msvc = first_build_error(
      "C:\\course\\my\\02.2-sphere.cpp(8,10): error C2065: 'y': undeclared identifier\n",
      "my/02.2-sphere.cpp");
  REQUIRE(msvc);
  CHECK(msvc->line == 8);
  CHECK(msvc->message == "'y': undeclared identifier");
}

TEST_CASE("build error: an error inside a library is told at the learner's line") {
  const auto error = first_build_error(
      "/usr/include/glm/x.hpp: In instantiation of 'float glm::length(float)':\n"
      "/course/my/02.2-sphere.cpp:14:21:   required from here\n"
      "/usr/include/glm/x.hpp:88:3: error: static assertion failed: needs a vector\n",
      "my/02.2-sphere.cpp");
  REQUIRE(error);
  CHECK(error->line == 14);
  CHECK(error->message == "static assertion failed: needs a vector");
}

TEST_CASE("build error: a function that is not defined is named") {
  const auto error = first_build_error(
      "/usr/bin/ld: test.cpp:(.text+0x1): undefined reference to `exercise::hit(float)'\n"
      "collect2: error: ld returned 1 exit status\n",
      "my/02.2-sphere.cpp");
  REQUIRE(error);
  CHECK(error->message.starts_with("exercise::hit(float) is declared in api.hpp"));
}

TEST_CASE("build error: trouble elsewhere is not blamed on the learner") {
  CHECK_FALSE(first_build_error("/course/test.cpp:3:1: error: nonsense\n", "my/02.2-sphere.cpp"));
  CHECK_FALSE(first_build_error("CMake Error: no disk\n", "my/02.2-sphere.cpp"));
}
