#include "runner/windows_words.hpp"

#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>

#include <cwchar>
#include <map>

namespace lt {

namespace {

void add_quoted(std::wstring& line, const std::wstring& word) {
  line += line.empty() ? L"\"" : L" \"";
  std::size_t backslashes = 0;
  for (const wchar_t c : word) {
    if (c == L'"') line.append(backslashes + 1, L'\\');
    line += c;
    backslashes = c == L'\\' ? backslashes + 1 : 0;
  }
  line.append(backslashes, L'\\');
  line += L'"';
}

struct IsLessIgnoringCase {
  bool operator()(const std::wstring& a, const std::wstring& b) const {
    return CompareStringOrdinal(a.data(), static_cast<int>(a.size()), b.data(),
                                static_cast<int>(b.size()), TRUE) == CSTR_LESS_THAN;
  }
};

}  // namespace

std::wstring wide(const std::string& text) {
  const auto bytes = static_cast<int>(text.size());
  const int size = MultiByteToWideChar(CP_UTF8, 0, text.data(), bytes, nullptr, 0);
  std::wstring result(static_cast<std::size_t>(size), L'\0');
  MultiByteToWideChar(CP_UTF8, 0, text.data(), bytes, result.data(), size);
  return result;
}

std::wstring command_line(const std::vector<std::string>& command) {
  std::wstring line;
  for (const std::string& word : command)
    add_quoted(line, wide(word));
  return line;
}

std::wstring environment_block(const std::vector<std::pair<std::string, std::string>>& added) {
  std::map<std::wstring, std::wstring, IsLessIgnoringCase> variables;
  wchar_t* const ours = GetEnvironmentStringsW();
  for (const wchar_t* entry = ours; *entry != L'\0'; entry += std::wcslen(entry) + 1) {
    const std::wstring text = entry;
    const std::size_t equals = text.find(L'=', 1);  // "=C:" is a name, too
    if (equals != std::wstring::npos) variables[text.substr(0, equals)] = text.substr(equals + 1);
  }
  FreeEnvironmentStringsW(ours);
  for (const auto& [name, value] : added)
    variables[wide(name)] = wide(value);
  std::wstring block;
  for (const auto& [name, value] : variables)
    block += name + L'=' + value + L'\0';
  return block + L'\0';
}

std::wstring find_program(const std::string& name) {
  if (name.find_first_of("/\\") != std::string::npos) return wide(name);
  std::wstring path(32768, L'\0');  // neither a variable nor a file name is longer
  path.resize(GetEnvironmentVariableW(L"PATH", path.data(), static_cast<DWORD>(path.size())));
  std::wstring file(32768, L'\0');
  file.resize(SearchPathW(path.c_str(), wide(name).c_str(), L".exe",
                          static_cast<DWORD>(file.size()), file.data(), nullptr));
  return file;
}

}  // namespace lt
