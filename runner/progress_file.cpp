#include "runner/progress_file.hpp"

#include "common/files.hpp"

namespace lt {

namespace {

constexpr std::size_t largest = 1 << 20;

}  // namespace

std::string ProgressFile::text() const {
  std::error_code ignored;
  return std::filesystem::exists(path_, ignored) ? read_file(path_, largest) : "";
}

LearnerProgress ProgressFile::load() const {
  return parse_progress(text()).value_or(LearnerProgress{});
}

bool ProgressFile::is_broken() const {
  std::error_code ignored;
  return std::filesystem::exists(path_, ignored) && !parse_progress(text());
}

void ProgressFile::change(const std::function<void(LearnerProgress&)>& edit) const {
  LearnerProgress progress = load();
  edit(progress);
  write_file_whole(path_, to_json(progress));
}

}  // namespace lt
