#include "common/files.hpp"

#include "common/testkit/catch.hpp"
#include "common/tests/other_process.hpp"
#include "common/tests/temporary_folder.hpp"

#ifndef _WIN32
#include <sys/stat.h>
#endif
#include <atomic>
#include <thread>

using namespace lt::test;
namespace fs = std::filesystem;

TEST_CASE("files: what is written is read back, byte for byte") {
  const TemporaryFolder folder;
  std::string bytes;
  for (int i = 0; i < 1000; ++i)
    bytes.push_back(static_cast<char>(i));
  for (const std::string& content : {bytes, std::string(), std::string("\r\n\0\x1a", 4)}) {
    lt::write_file_whole(folder / "file", content);
    CHECK(lt::read_file(folder / "file") == content);
    CHECK(get(folder / "file") == content);
  }
  CHECK(folder.names() == std::vector<std::string>{"file"});
}

TEST_CASE("files: missing folders are made") {
  const TemporaryFolder folder;
  lt::write_file_whole(folder / "a/b/c.txt", "deep");
  CHECK(get(folder / "a/b/c.txt") == "deep");
}

TEST_CASE("files: what cannot be read is named in one line with the remedy") {
  const TemporaryFolder folder;
  const auto complaint = [](const fs::path& path) {
    return input_error([&] { (void)lt::read_file(path); });
  };
  CHECK(is_one_line_with_remedy(complaint(folder / "missing.png"), "missing.png"));
  CHECK(is_one_line_with_remedy(complaint(folder / "two\nlines"), "two?lines"));
  CHECK(is_one_line_with_remedy(complaint(folder.path()), folder.path().string()));
  CHECK(is_one_line_with_remedy(complaint(""), "no file name"));
  CHECK(is_one_line_with_remedy(complaint(folder / std::string(5000, 'x')), "xxx"));
  put(folder / "file", "text");
  CHECK(is_one_line_with_remedy(complaint(folder / "file/inside"), "inside"));
}

TEST_CASE("files: a file larger than the limit is not read") {
  const TemporaryFolder folder;
  put(folder / "large", std::string(101, 'x'));
  CHECK(lt::read_file(folder / "large", 101).size() == 101);
  const auto complaint = input_error([&] { (void)lt::read_file(folder / "large", 100); });
  CHECK(is_one_line_with_remedy(complaint, "large"));
  CHECK(contains(complaint, "101 bytes"));
}

TEST_CASE("files: a target that is a folder or lies below a file is refused") {
  const TemporaryFolder folder;
  fs::create_directory(folder / "folder");
  put(folder / "file", "old");
  const auto complaint = [](const fs::path& path) {
    return output_error([&] { lt::write_file_whole(path, "new"); });
  };
  CHECK(is_one_line_with_remedy(complaint(folder / "folder"), "folder"));
  CHECK(is_one_line_with_remedy(complaint(folder / "folder/"), "folder"));
  CHECK(is_one_line_with_remedy(complaint(folder / "file/inside"), "inside"));
  CHECK(is_one_line_with_remedy(complaint(""), "no file name"));
  CHECK(get(folder / "file") == "old");
  CHECK(folder.names() == std::vector<std::string>{"file", "folder"});
}

TEST_CASE("files: someone who reads while another writes sees one whole version") {
  const TemporaryFolder folder;
  const fs::path path = folder / "file";
  const std::string a(200'000, 'a');
  const std::string b(150'000, 'b');
  lt::write_file_whole(path, a);
  std::atomic<bool> writing{true};
  std::thread writer([&] {
    for (int i = 0; i < 200; ++i)
      lt::write_file_whole(path, i % 2 == 0 ? b : a);
    writing = false;
  });
  int halves = 0;
  do {
    const std::string seen = lt::read_file(path);
    if (seen != a && seen != b) ++halves;
  } while (writing);
  writer.join();
  CHECK(halves == 0);
}

// Not on Windows, which has no such permissions, pipes, limits, and lets few people make links.
#ifndef _WIN32

TEST_CASE("files: without permission nothing is read") {
  const TemporaryFolder folder;
  put(folder / "secret", "text");
  fs::permissions(folder / "secret", fs::perms::none);
  fs::create_directory(folder / "closed");
  fs::permissions(folder / "closed", fs::perms::none);
  for (const std::string name : {"secret", "closed/file"}) {
    const std::string complaint =
        as_ordinary_user([&] { return input_error([&] { (void)lt::read_file(folder / name); }); });
    INFO(complaint);
    CHECK(is_one_line_with_remedy(complaint, name));
    CHECK(contains(complaint, "ermission"));
  }
}

TEST_CASE("files: a pipe or a device is refused instead of waited for") {
  const TemporaryFolder folder;
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  for (const fs::path& path : {folder / "pipe", fs::path("/dev/zero")}) {
    CHECK(contains(input_error([&] { (void)lt::read_file(path); }), "no regular file"));
    CHECK(contains(output_error([&] { lt::write_file_whole(path, "x"); }), "not a file"));
  }
  CHECK(fs::is_character_file("/dev/zero"));
}

TEST_CASE("files: in a folder that may not be written the old file stays") {
  const TemporaryFolder folder;
  put(folder / "file", "old");
  fs::permissions(folder.path(),
                  fs::perms::owner_all | fs::perms::others_exec | fs::perms::others_read);
  if (geteuid() != 0) fs::permissions(folder.path(), fs::perms::owner_exec | fs::perms::owner_read);
  for (const std::string name : {"file", "new", "new folder/file"}) {
    const std::string complaint = as_ordinary_user(
        [&] { return output_error([&] { lt::write_file_whole(folder / name, "new"); }); });
    INFO(complaint);
    CHECK(is_one_line_with_remedy(complaint, name));
    CHECK(contains(complaint, "ermission"));
  }
  fs::permissions(folder.path(), fs::perms::owner_all);
  CHECK(get(folder / "file") == "old");
  CHECK(folder.names() == std::vector<std::string>{"file"});
}

TEST_CASE("files: when the disk is full the old file stays and nothing is left behind") {
  const TemporaryFolder folder;
  put(folder / "file", "old");
  // Fails in the middle of the bytes, or only when the last ones are flushed.
  for (const std::size_t size : {5'000'000, 4097}) {
    const std::string complaint = with_small_files(4096, [&] {
      return output_error([&] { lt::write_file_whole(folder / "file", std::string(size, 'x')); });
    });
    INFO(complaint);
    CHECK(is_one_line_with_remedy(complaint, "file"));
    CHECK(contains(complaint, "too large"));
    CHECK(get(folder / "file") == "old");
    CHECK(folder.names() == std::vector<std::string>{"file"});
  }
}

TEST_CASE("files: a link stays a link and its target is replaced") {
  const TemporaryFolder folder;
  put(folder / "target", "old");
  fs::create_symlink("target", folder / "link");
  lt::write_file_whole(folder / "link", "new");
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(get(folder / "target") == "new");
  CHECK(folder.names() == std::vector<std::string>{"link", "target"});
}

#endif
