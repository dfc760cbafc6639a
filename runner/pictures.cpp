#include "runner/pictures.hpp"

#include <algorithm>

#include "common/files.hpp"
#include "common/parallel.hpp"
#include "common/progress.hpp"
#include "runner/build.hpp"
#include "runner/text.hpp"

namespace lt {

namespace fs = std::filesystem;

namespace {

bool is_made_of_pixels(const Picture& picture) {
  return picture.file.ends_with(".png");
}

// A word as a shell wants it.
std::string quoted(const std::string& word) {
  const bool is_plain = !word.empty() && word.find_first_not_of(
                                             "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                             "0123456789-_./,:=+") == std::string::npos;
  return is_plain ? word : "'" + word + "'";
}

// What a picture costs, about: its pixels; a plot as much as a small picture.
std::int64_t weight(const PictureJob& job) {
  constexpr std::int64_t plot = 50'000;
  return std::max(plot, std::int64_t{job.size.width} * job.size.height);
}

void make_picture(const Home& home, const PictureJob& job) {
  const std::string& chapter = job.picture.chapter;
  const fs::path program = built_program(home.build() / "chapters" / chapter, chapter);
  std::vector<std::string> command = picture_arguments(job.picture, job.size, job.out);
  command.insert(command.begin(), program.string());
  fs::create_directories(job.out.parent_path());
  ProcessOptions options;
  options.folder = home.root;
  const ProcessResult result = run_process(command, options);
  if (!result.succeeded() || !fs::exists(job.out)) {
    throw BuildFailed("\n" + result.output + join(command, " ") + "\n");
  }
}

}  // namespace

std::vector<Picture> load_pictures(const Home& home, const std::vector<std::string>& chapters) {
  std::vector<Picture> pictures;
  for (const std::string& chapter : chapters) {
    const fs::path file = home.root / "chapters" / chapter / "pictures.json";
    if (!fs::exists(file)) continue;
    for (Picture& picture : parse_pictures(read_file(file, 1 << 20), chapter, file)) {
      pictures.push_back(std::move(picture));
    }
  }
  return pictures;
}

std::vector<std::string> picture_arguments(const Picture& picture, PictureSize size,
                                           const fs::path& out) {
  std::vector<std::string> words = picture.args;
  if (is_made_of_pixels(picture) && size.width > 0) {
    for (const std::string& word : {std::string("--width"), std::to_string(size.width),
                                    std::string("--height"), std::to_string(size.height)}) {
      words.push_back(word);
    }
  }
  words.emplace_back("--out");
  words.push_back(out.string());
  return words;
}

std::string picture_command(const Picture& picture, PictureSize size, const std::string& out) {
  std::string text = "./learn chapter " + std::to_string(std::stoi(picture.chapter.substr(2)));
  for (const std::string& word : picture_arguments(picture, size, out))
    text += " " + quoted(word);
  return text;
}

PictureSize render_size(const Picture& picture, bool is_quick) {
  if (!is_made_of_pixels(picture)) return {};
  if (!is_quick) return picture.full;
  const PictureSize third{std::max(1, picture.full.width / 3),
                          std::max(1, picture.full.height / 3)};
  return picture.stored.value_or(third);
}

PictureSize png_size(std::string_view bytes) {
  // Signature (8 bytes), length and name of the header chunk (8), then width and height, each four
  // bytes with the highest first (PNG specification, 11.2.2).
  if (bytes.size() < 24 || !bytes.starts_with("\x89PNG\r\n\x1a\n")) return {};
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = at; i < at + 4; ++i) {
      value = value * 256 + static_cast<unsigned char>(bytes[i]);
    }
    return value;
  };
  return {number(16), number(20)};
}

void make_pictures(const Home& home, const std::vector<PictureJob>& jobs,
                   const std::string& label) {
  std::int64_t total = 0;
  for (const PictureJob& job : jobs)
    total += weight(job);
  Progress progress(label, total);
  for_each_index(static_cast<int>(jobs.size()), 0, [&](int i) {
    const PictureJob& job = jobs[static_cast<std::size_t>(i)];
    make_picture(home, job);
    progress.advance(weight(job));
  });
}

}  // namespace lt
