#ifdef _WIN32  // the other systems take words as they are
#include "runner/windows_words.hpp"

#include "common/testkit/catch.hpp"

using namespace lt;

TEST_CASE("windows: UTF-8 becomes UTF-16 - and broken bytes its replacement mark") {
  CHECK(wide("") == L"");
  CHECK(wide("\xc3\xbc \xe2\x82\xac \xf0\x9f\x98\x80") == L"\u00fc \u20ac \xd83d\xde00");
  CHECK(wide("a\xff") == L"a\xfffd");
}

TEST_CASE("windows: variables are sorted - and one in other letters is the same") {
  const std::wstring block =
      environment_block({{"z_last", ""}, {"A_First", "0"}, {"a_first", "1"}});
  const std::size_t first = block.find(std::wstring(L"A_First=1") + L'\0');
  const std::size_t last = block.find(std::wstring(L"z_last=") + L'\0');
  REQUIRE(first != std::wstring::npos);
  REQUIRE(last != std::wstring::npos);
  CHECK(first < last);
  CHECK(block.find(L"a_first") == std::wstring::npos);
  CHECK(block.substr(block.size() - 2) == std::wstring(2, L'\0'));
}
#endif
