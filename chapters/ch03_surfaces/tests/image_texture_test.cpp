// Textures from files: light is decoded, numbers are not.
#include "ch03_surfaces/image_texture.hpp"

#include <filesystem>

#include "ch03_surfaces/mistakes.hpp"
#include "common/pixel_io.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

// A picture file that is gone when the test ends.
class PictureFile {
 public:
  PictureFile(const std::string& name, const Pixels8& pixels)
      : path_(std::filesystem::temp_directory_path() / ("ch03_image_texture_" + name)) {
    write_png(path_, pixels);
  }
  ~PictureFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  PictureFile(const PictureFile&) = delete;
  PictureFile& operator=(const PictureFile&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

TEST_CASE("image textures: codes become linear light") {
  // By IEC 61966-2-1: ((188 / 255 + 0.055) / 1.055)^2.4 = 0.50289, (10 / 255) / 12.92 = 0.0030353.
  const PictureFile file("decoded.png", {2, 1, {0, 255, 188, 10, 188, 128}});
  const Texture texture = load_color(file.path());
  CHECK(texture->at(0, 0).r == 0.0f);
  CHECK(texture->at(0, 0).g == Approx(1.0));
  CHECK(texture->at(0, 0).b == Approx(0.50289).epsilon(1e-4));
  CHECK(texture->at(1, 0).r == Approx(0.0030353).epsilon(1e-4));
  CHECK(texture->at(1, 0).b == Approx(0.21586).epsilon(1e-4));
}

TEST_CASE("image textures: a normal map's codes are numbers and stay numbers") {
  const PictureFile file("normals.png", {1, 1, {128, 64, 255}});
  const Rgb texel = load_normals(file.path())->at(0, 0);
  CHECK(texel.x == Approx(128.0 / 255.0));
  CHECK(texel.y == Approx(64.0 / 255.0));
  CHECK(texel.z == Approx(1.0));
}

TEST_CASE("image textures: rows of an odd width are not sheared") {
  Pixels8 pixels{5, 3, {}};
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 5; ++x)
      pixels.rgb.insert(pixels.rgb.end(),
                        {static_cast<std::uint8_t>(50 * x), static_cast<std::uint8_t>(100 * y), 7});
  const PictureFile file("odd.png", pixels);
  const Texture color = load_color(file.path());
  const Texture normals = load_normals(file.path());
  REQUIRE(color->width() == 5);
  REQUIRE(color->height() == 3);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 5; ++x) {
      CHECK(to_code(color->at(x, y).r) == 50 * x);
      CHECK(to_code(color->at(x, y).g) == 100 * y);
      CHECK(normals->at(x, y).r * 255.0f == Approx(50.0 * x));
      CHECK(normals->at(x, y).g * 255.0f == Approx(100.0 * y));
    }
}

TEST_CASE("image textures: a missing file is the person's error") {
  CHECK_THROWS_AS(load_color("no/such/picture.png"), InputError);
  CHECK_THROWS_AS(load_normals("no/such/picture.png"), InputError);
}

TEST_CASE("image textures: the planted mistake takes codes for light and is too bright") {
  const Image half(1, 1, Rgb(0.5f));
  CHECK(mistakes::not_decoded(half)->at(0, 0).r == Approx(0.73536).epsilon(1e-4));  // code 188
}
