#include "runner/test_report.hpp"

#include "common/testkit/catch.hpp"

using namespace lt;

TEST_CASE("test report: a test that did not run is a failure and is named") {
  const TestReport report = read_test_report(
      "<testsuite name=\"x\" tests=\"5\" failures=\"1\" disabled=\"1\" skipped=\"1\">\n"
      "\t<testcase name=\"a\" classname=\"a\" time=\"0.01\" status=\"run\">\n"
      "\t<testcase name=\"b &lt; &quot;c&quot;\" classname=\"b\" status=\"fail\">\n"
      "\t<testcase name=\"skipped\" classname=\"c\" status=\"notrun\">\n"
      "\t<testcase name=\"off\" classname=\"d\" status=\"disabled\">\n"
      "\t<testcase name=\"e\" classname=\"e\" status=\"run\"/>\n");
  CHECK(report.passed == 2);
  CHECK(report.failed == std::vector<std::string>{"b < \"c\""});
  CHECK(report.not_run == std::vector<std::string>{"skipped", "off"});
  CHECK(report.failures() == 3);
}

TEST_CASE("test report: an empty file has no passes") {
  CHECK(read_test_report("").passed == 0);
  CHECK(read_test_report("<testcase name=").passed == 0);
}
