#include "ch03_surfaces/world_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

const Image& the_map() {
  static const Image map = world_map(1024);
  return map;
}

Rgb color_at(double lon, double lat) {
  const Image& map = the_map();
  return map.at(static_cast<int>((lon + 180.0) / 360.0 * map.width()),
                static_cast<int>((90.0 - lat) / 180.0 * map.height()));
}

/// Water is the only thing on the map that is much bluer than red.
bool is_sea(double lon, double lat) {
  const Rgb color = color_at(lon, lat);
  return color.b > 2.0f * color.r;
}

bool is_ice(double lon, double lat) {
  const Rgb color = color_at(lon, lat);
  return std::min({color.r, color.g, color.b}) > 0.55f;
}

struct Place {
  std::string name;
  double lon, lat;
};

/// Area in millions of square kilometres of one outline (or of all), on a sphere of radius 6371 km.
double area_of(std::string_view name) {
  Image shares(1440, 720);
  for (const Outline& outline : world_outlines())
    if (outline.name == name || name == "all") fill(shares, outline);
  const double texel = std::numbers::pi / 720.0;  // radians, both ways
  double area = 0.0;
  for (int y = 0; y < shares.height(); ++y)
    for (int x = 0; x < shares.width(); ++x)
      area += shares.at(x, y).r * std::sin((y + 0.5) * texel) * texel * texel;
  return area * 6.371 * 6.371;
}

}  // namespace

TEST_CASE("world: fill shares out a rectangle's texels exactly, and wraps at 180 degrees") {
  // 16 x 8 texels of 22.5 degrees. From -90 (column 4) to 33.75 (middle of column 9);
  // 45 (row 2) to 0 (row 4).
  Image shares(16, 8);
  fill(shares, {"", true, {{-90, 45}, {33.75, 45}, {33.75, 0}, {-90, 0}}});
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 16; ++x) {
      const bool row_inside = y == 2 || y == 3;
      const float expected = !row_inside || x < 4 || x > 9 ? 0.0f : x == 9 ? 0.5f : 1.0f;
      INFO(x << ", " << y);
      CHECK(shares.at(x, y).r == Approx(expected).margin(1e-6));
    }

  // Beyond 180 degrees: the last column and the first.
  Image wrapped(16, 8);
  fill(wrapped, {"", true, {{157.5, 90}, {202.5, 90}, {202.5, -90}, {157.5, -90}}});
  for (int x = 0; x < 16; ++x)
    CHECK(wrapped.at(x, 4).r == (x == 0 || x == 15 ? 1.0f : 0.0f));
}

TEST_CASE("world: fill cuts a lake out of land and leaves out what an outline goes around") {
  Image shares(36, 18);  // 10 degrees
  const std::vector<LonLat> square{{-50, 50}, {50, 50}, {50, -50}, {-50, -50}};
  fill(shares, {"", true, square});
  fill(shares, {"", false, {{-20, 20}, {20, 20}, {20, -20}, {-20, -20}}});
  CHECK(shares.at(18, 8).r == 0.0f);
  CHECK(shares.at(14, 8).r == 1.0f);

  // A horseshoe, open to the right: two crossings on its upper arm's row, none in its mouth.
  Image horseshoe(36, 18);
  fill(horseshoe,
       {"",
        true,
        {{-50, 50}, {50, 50}, {50, 20}, {-20, 20}, {-20, -20}, {50, -20}, {50, -50}, {-50, -50}}});
  CHECK(horseshoe.at(20, 5).r == 1.0f);
  CHECK(horseshoe.at(20, 8).r == 0.0f);
  CHECK(horseshoe.at(14, 8).r == 1.0f);
}

TEST_CASE("world: outlines stay on the globe") {
  for (const Outline& outline : world_outlines()) {
    INFO(outline.name);
    CHECK(outline.points.size() >= 3);
    for (const LonLat& point : outline.points) {
      CHECK(std::abs(point.lat) <= 90.0);
      CHECK(point.lon >= -180.0);
      CHECK(point.lon <= 191.0);  // Chukotka's end lies beyond 180
    }
  }
}

TEST_CASE("world: land has its real size") {
  // Millions of square kilometres, as in any atlas; the table is coarse: 6 %, islands 15 %.
  // "Eurasia" and "America" are the mainlands with their lakes: the continents' sizes without their
  // islands (about 3.2 and 4.1), and with the Caspian and the Black Sea (0.8).
  CHECK(area_of("all") == Approx(148.9 + 1.6).epsilon(0.03));  // with Antarctica's ice shelves
  CHECK(area_of("Africa") == Approx(29.8).epsilon(0.06));
  CHECK(area_of("Eurasia") == Approx(44.6 + 10.2 - 3.2 + 0.8).epsilon(0.06));
  CHECK(area_of("America") == Approx(24.7 + 17.8 - 4.1).epsilon(0.06));
  CHECK(area_of("Antarctica") == Approx(14.0).epsilon(0.06));
  CHECK(area_of("Australia") == Approx(7.6).epsilon(0.06));
  CHECK(area_of("Greenland") == Approx(2.17).epsilon(0.06));
  CHECK(area_of("New Guinea") == Approx(0.786).epsilon(0.15));
  CHECK(area_of("Borneo") == Approx(0.748).epsilon(0.15));
  CHECK(area_of("Madagascar") == Approx(0.587).epsilon(0.15));
  CHECK(area_of("Baffin Island") == Approx(0.507).epsilon(0.15));
  CHECK(area_of("Sumatra") == Approx(0.443).epsilon(0.15));
  CHECK(area_of("Honshu") == Approx(0.228).epsilon(0.15));
  CHECK(area_of("Great Britain") == Approx(0.209).epsilon(0.15));
  CHECK(area_of("New Zealand, south") == Approx(0.150).epsilon(0.15));
  CHECK(area_of("Iceland") == Approx(0.102).epsilon(0.15));
}

TEST_CASE("world map: well-known places on land are land") {
  const Place places[] = {{"Madrid", -3.7, 40.4},
                          {"Paris", 2.4, 48.9},
                          {"Milan", 9.2, 45.5},
                          {"Berlin", 13.4, 52.5},
                          {"Moscow", 37.6, 55.8},
                          {"Oestersund in Sweden", 14.6, 63.2},
                          {"Ankara", 32.9, 39.9},
                          {"Riyadh", 46.7, 24.7},
                          {"Isfahan", 51.7, 32.7},
                          {"Delhi", 77.2, 28.6},
                          {"Nagpur", 79.1, 21.1},
                          {"Ulaanbaatar", 106.9, 47.9},
                          {"Xi'an", 108.9, 34.3},
                          {"Yakutsk", 129.7, 62.0},
                          {"Nagano in Japan", 138.0, 36.2},
                          {"Khartoum", 32.5, 15.6},
                          {"Timbuktu", -3.0, 16.8},
                          {"Garowe, in Africa's horn", 48.5, 8.4},
                          {"Nairobi", 36.8, -1.3},
                          {"Kinshasa", 15.3, -4.3},
                          {"Johannesburg", 28.0, -26.2},
                          {"Antananarivo", 47.5, -18.9},
                          {"Regina in Canada", -104.6, 50.4},
                          {"Fairbanks in Alaska", -147.7, 64.8},
                          {"Denver", -105.0, 39.7},
                          {"Atlanta", -84.4, 33.7},
                          {"Orlando in Florida", -81.4, 28.5},
                          {"Mexico City", -99.1, 19.4},
                          {"Bogota", -74.1, 4.7},
                          {"Manaus", -60.0, -3.1},
                          {"Brasilia", -47.9, -15.8},
                          {"La Paz", -68.1, -16.5},
                          {"Cordoba in Argentina", -64.2, -31.4},
                          {"Alice Springs", 133.9, -23.7},
                          {"Canberra", 149.1, -35.3},
                          {"Twizel in New Zealand", 170.1, -44.3},
                          {"Taupo in New Zealand", 176.1, -38.7},
                          {"inner Borneo", 114.5, 0.5}};
  for (const Place& place : places) {
    INFO(place.name);
    CHECK_FALSE(is_sea(place.lon, place.lat));
    CHECK_FALSE(is_ice(place.lon, place.lat));
  }
}

TEST_CASE("world map: well-known waters are water") {
  const Place places[] = {{"North Atlantic", -40.0, 30.0},
                          {"equatorial Atlantic", -20.0, 0.0},
                          {"South Atlantic", -15.0, -30.0},
                          {"off Recife", -30.0, -8.0},
                          {"North Pacific", -150.0, 40.0},
                          {"date line", 179.9, 20.0},
                          {"South Pacific", -120.0, -30.0},
                          {"Indian Ocean", 80.0, -20.0},
                          {"Arabian Sea", 65.0, 15.0},
                          {"Bay of Bengal", 88.0, 14.0},
                          {"South China Sea", 114.0, 14.5},
                          {"Sea of Japan", 135.0, 40.0},
                          {"Coral Sea", 155.0, -17.0},
                          {"Tasman Sea", 162.0, -38.0},
                          {"western Mediterranean", 5.0, 40.0},
                          {"eastern Mediterranean", 18.0, 35.0},
                          {"Black Sea", 34.0, 43.2},
                          {"Caspian Sea", 50.8, 41.5},
                          {"Red Sea", 38.2, 20.5},
                          {"North Sea", 3.0, 56.0},
                          {"Baltic Sea", 19.7, 58.0},
                          {"Gulf of Bothnia", 19.8, 62.0},
                          {"Norwegian Sea", 3.0, 67.0},
                          {"Bay of Biscay", -5.0, 45.5},
                          {"Gulf of Guinea", 3.0, 2.0},
                          {"Mozambique Channel", 41.0, -20.0},
                          {"Hudson Bay", -85.0, 60.0},
                          {"Gulf of Mexico", -90.0, 25.0},
                          {"Caribbean Sea", -75.0, 15.0},
                          {"Gulf of Alaska", -145.0, 56.0},
                          {"Bering Sea", -175.0, 58.0},
                          {"Sea of Okhotsk", 150.0, 55.0},
                          {"Great Australian Bight", 131.0, -34.5},
                          {"Drake Passage", -65.0, -59.5},
                          {"Weddell Sea", -40.0, -70.0}};
  for (const Place& place : places) {
    INFO(place.name);
    CHECK(is_sea(place.lon, place.lat));
  }
}

TEST_CASE(
    "world map: ice at the poles and on Greenland, sand in the Sahara, forest on the Amazon") {
  for (int lon = -179; lon < 180; lon += 10) {
    INFO("longitude " << lon);
    CHECK(is_ice(lon, 89.0));
    CHECK(is_ice(lon, -89.0));
  }
  CHECK(is_ice(-40.0, 75.0));
  CHECK(is_ice(106.8, -78.5));  // Vostok
  CHECK(is_ice(110.0, -69.0));  // and near the coast
  CHECK(is_ice(0.0, -73.0));

  // Satellites see about 0.35 to 0.45 of the light come back from the Sahara, and less than 0.15
  // from rain forest, most of it green.
  const Rgb sahara = color_at(10.0, 23.0);
  CHECK(sahara.r > sahara.g);
  CHECK(sahara.g > sahara.b);
  CHECK((sahara.r + sahara.g + sahara.b) / 3.0f == Approx(0.4f).margin(0.1f));
  const Rgb amazon = color_at(-62.0, -5.0);
  CHECK(amazon.g > std::max(amazon.r, amazon.b));
  CHECK(amazon.g < 0.15f);
}

TEST_CASE("globe_fbm: fits at 180 degrees, and is one value at each pole") {
  const auto at = [](float u, float v) { return globe_fbm({u, v}, 40, 5, 1); };
  const float hair = 1e-6f;
  for (int i = 1; i < 100; ++i) {
    const float t = static_cast<float>(i) / 100.0f;
    CHECK(at(hair, t) == Approx(at(1.0f - hair, t)).margin(1e-3));
    CHECK(at(t, hair) == Approx(at(0.0f, hair)).margin(1e-3));
    CHECK(at(t, 1.0f - hair) == Approx(at(0.0f, 1.0f - hair)).margin(1e-3));
  }
}

TEST_CASE("globe_fbm: goes from one map to the other without a step") {
  // 20 cells from pole to pole and slopes of up to about 3 to a cell: each octave's slope is up to
  // 0.5 * 20 * 3 = 30, five octaves' 150, and 0.015 in 1e-4.
  for (const float u : {0.05f, 0.2f, 0.4f, 0.6f, 0.9f})
    for (int i = 0; i < 10000; ++i) {
      const float v = static_cast<float>(i) * 1e-4f;
      REQUIRE(std::abs(globe_fbm({u, v + 1e-4f}, 40, 5, 1) - globe_fbm({u, v}, 40, 5, 1)) < 0.015f);
    }
}

TEST_CASE("world map: reflectances, and no seam at 180 degrees") {
  const Image& map = the_map();
  const auto step = [&](int x, int y) {
    const Rgb d = map.at(x, y) - map.at((x + 1) % map.width(), y);
    return static_cast<double>(dot(d, d));
  };
  double inside = 0.0, seam = 0.0;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const Rgb color = map.at(x, y);
      REQUIRE(glm::all(glm::greaterThanEqual(color, Rgb(0.0f))));
      REQUIRE(glm::all(glm::lessThanEqual(color, Rgb(1.0f))));
      inside += step(x, y) / map.width();
    }
    seam += step(map.width() - 1, y);
  }
  CHECK(seam < 0.25 * inside);  // little coast is at 180 degrees: a mean meridian crosses far more
}
