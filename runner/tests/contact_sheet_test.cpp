#include "runner/contact_sheet.hpp"

#include "common/testkit/catch.hpp"
#include "runner/pictures.hpp"

using namespace lt;

namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("contact sheet: captions and commands cannot become markup") {
  const std::string html = contact_sheet({{"2. <b>", "ch02/a.png", "<i>", "\"><script>x</script>",
                                           "./learn chapter 2 --label 'a & b'", "9 x 9"}});
  CHECK_FALSE(has(html, "<script"));
  CHECK_FALSE(has(html, "<b>"));
  CHECK_FALSE(has(html, "<i>"));
  CHECK(has(html, "alt=\"&quot;&gt;&lt;script&gt;x&lt;/script&gt;\""));
  CHECK(has(html, "&#39;a &amp; b&#39;"));
}

TEST_CASE("contact sheet: one section a chapter, every picture a link, nothing from elsewhere") {
  const std::string html = contact_sheet({{"1. Pixels", "ch01/a.png", "", "A", "c", "d"},
                                          {"1. Pixels", "ch01/b.svg", "", "B", "c", "d"},
                                          {"2. Rays", "ch02/a.png", "", "C", "c", "d"}});
  CHECK(html.find("<h2>1. Pixels") == html.rfind("<h2>1. Pixels"));
  CHECK(has(html, "<a href=\"ch01/a.png\"><img src=\"ch01/a.png\""));
  CHECK(has(html, "<a href=\"ch01/b.svg\" class=\"plot\""));
  CHECK(has(html, "3 pictures"));
  CHECK_FALSE(has(html, "http"));
  CHECK_FALSE(has(html, "//"));
}

TEST_CASE("pictures: the command is what one types, quoted where a shell needs it") {
  Picture picture;
  picture.chapter = "ch02_ray_casting";
  picture.file = "room.png";
  picture.args = {"--view", "normals", "--label", "a b"};
  CHECK(picture_command(picture, {480, 384}, "out/room.png") ==
        "./learn chapter 2 --view normals --label 'a b' --width 480 --height 384 "
        "--out out/room.png");
  picture.file = "plot.svg";
  CHECK(picture_command(picture, {480, 384}, "p.svg") ==
        "./learn chapter 2 --view normals --label 'a b' --out p.svg");
}

TEST_CASE("pictures: a PNG's size is read from its header and from nothing else") {
  const std::string header("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\x03\x84\0\0\x02\xd0", 24);
  CHECK(png_size(header).width == 900);
  CHECK(png_size(header).height == 720);
  CHECK(png_size(header.substr(0, 23)).width == 0);
  CHECK(png_size("<svg>").width == 0);
}
