#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "ch03_surfaces/bricks.hpp"
#include "ch03_surfaces/concrete.hpp"
#include "ch03_surfaces/planks.hpp"
#include "ch03_surfaces/tiles.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/statistics.hpp"

using namespace lt;

namespace {

struct NamedMaps {
  std::string name;
  TextureMaps maps;
};

const std::vector<NamedMaps>& all_patterns() {
  static const std::vector<NamedMaps> patterns{{"bricks", bricks(256)},
                                               {"concrete", concrete(256)},
                                               {"tiles", tiles(256)},
                                               {"planks", planks(256)}};
  return patterns;
}

vec3 decoded(const TextureMaps& maps, int x, int y) {
  return maps.normals.at(x, y) * 2.0f - 1.0f;
}

struct NamedPattern {
  std::string name;
  PatternPoint (*at)(vec2);
};

constexpr float hair = 2e-6f;

/// How much a pattern differs between two lines, root mean square along them.
/// @param before, after  u of two upright lines, or v of two level ones
PatternPoint jump(const NamedPattern& pattern, float before, float after, bool upright) {
  const int samples = 500;
  Rgb color(0.0f);
  float height = 0.0f;
  for (int i = 0; i < samples; ++i) {
    const float along = (static_cast<float>(i) + 0.5f) / samples;
    const auto at = [&](float x) { return pattern.at(upright ? vec2(x, along) : vec2(along, x)); };
    const PatternPoint p = at(before), q = at(after);
    color += (q.color - p.color) * (q.color - p.color) / static_cast<float>(samples);
    height += (q.height - p.height) * (q.height - p.height) / static_cast<float>(samples);
  }
  return {glm::sqrt(color), std::sqrt(height)};
}

/// The pieces of the square, wrapped round, where `inside` holds: texels that touch side by side.
int count_pieces(int size, const std::function<bool(vec2)>& inside) {
  std::vector<bool> open(static_cast<std::size_t>(size) * size);
  for (int i = 0; i < size * size; ++i)
    open[i] = inside((vec2(i % size, i / size) + 0.5f) / static_cast<float>(size));

  int pieces = 0;
  for (int start = 0; start < size * size; ++start) {
    if (!open[start]) continue;
    ++pieces;
    std::vector<int> to_visit{start};
    open[start] = false;
    while (!to_visit.empty()) {
      const int x = to_visit.back() % size, y = to_visit.back() / size;
      to_visit.pop_back();
      for (const ivec2 d : {ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1)}) {
        const int next = wrap(y + d.y, size) * size + wrap(x + d.x, size);
        if (open[next]) to_visit.push_back(next);
        open[next] = false;
      }
    }
  }
  return pieces;
}

}  // namespace

TEST_CASE("patterns: reflectances are between 0 and 1, light, and hardly ever cut off") {
  for (const auto& [name, maps] : all_patterns()) {
    INFO(name);
    double sum = 0.0;
    int cut_off = 0;
    for (int y = 0; y < maps.color.height(); ++y)
      for (int x = 0; x < maps.color.width(); ++x)
        for (int c = 0; c < 3; ++c) {
          const float value = maps.color.at(x, y)[c];
          REQUIRE(value >= 0.0f);
          REQUIRE(value <= 1.0f);
          cut_off += value == 0.0f || value == 1.0f;
          sum += value;
        }
    const double count = 3.0 * maps.color.width() * maps.color.height();
    CHECK(cut_off < 0.002 * count);
    // A tint multiplies them, so they must not be dark, nor white without room above.
    CHECK(sum / count > 0.45);
    CHECK(sum / count < 0.8);
  }
}

TEST_CASE("patterns: normals are unit and point out of the wall") {
  for (const auto& [name, maps] : all_patterns()) {
    INFO(name);
    for (int y = 0; y < maps.normals.height(); ++y)
      for (int x = 0; x < maps.normals.width(); ++x) {
        const vec3 n = decoded(maps, x, y);
        REQUIRE(glm::length(n) == Approx(1.0f).margin(1e-5));
        REQUIRE(n.z > 0.25f);  // steeper than 75 degrees would be no surface, but a mistake
      }
  }
}

TEST_CASE("patterns: opposite edges fit as well as neighbours inside") {
  // Two tiles or panels may differ in colour where they meet, at an edge as anywhere: all lines at
  // which parts can meet are multiples of 1/24; 10 % for luck. A hair of 4e-6 on slopes of up to
  // 1/texel, 512, gives 0.002 in colour; heights are 0.005 at most, and so is their share.
  const NamedPattern patterns[] = {
      {"bricks", bricks_at}, {"concrete", concrete_at}, {"tiles", tiles_at}, {"planks", planks_at}};
  for (const NamedPattern& pattern : patterns)
    for (const bool upright : {true, false}) {
      PatternPoint inside{Rgb(0.002f), 1e-5f};
      for (int i = 1; i < 24; ++i) {
        const float line = static_cast<float>(i) / 24.0f;
        const PatternPoint here = jump(pattern, line - hair, line + hair, upright);
        inside = {glm::max(inside.color, here.color), std::max(inside.height, here.height)};
      }
      INFO(pattern.name << (upright ? ", left and right" : ", top and bottom"));
      const PatternPoint seam = jump(pattern, 1.0f - hair, hair, upright);
      CHECK(seam.color.r <= 1.1f * inside.color.r);
      CHECK(seam.color.g <= 1.1f * inside.color.g);
      CHECK(seam.color.b <= 1.1f * inside.color.b);
      CHECK(seam.height <= 1.1f * inside.height);
    }
}

TEST_CASE("patterns: every size shows the same wall") {
  // A texel of the small picture against the 4 x 4 that it covers in the large one, and against the
  // 4 x 4 half a brick beside.
  const TextureMaps small = bricks(128), large = bricks(512);
  const auto distance = [&](int x, int y, int shift) {
    float mean = 0.0f;
    for (int k = 0; k < 16; ++k)
      mean += large.color.at(wrap(4 * (x + shift) + k % 4, 512), 4 * y + k / 4).g / 16.0f;
    return std::abs(small.color.at(x, y).g - mean);
  };
  RunningMean same, beside;
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) {
      same.add(distance(x, y, 0));
      beside.add(distance(x, y, 128 / brick_wall::per_course / 2));
    }
  CHECK(same.mean() < 0.5 * beside.mean());
}

TEST_CASE("bricks: as many bricks as courses times bricks, in one net of mortar") {
  using namespace brick_wall;
  const auto is_brick = [](vec2 uv) { return bricks_at(uv).height > 0.5f * depth; };
  CHECK(count_pieces(512, is_brick) == courses * per_course);
  CHECK(count_pieces(512, std::not_fn(is_brick)) == 1);
}

TEST_CASE(
    "bricks: mortar lies its depth behind the faces, and each joint is over a brick's middle") {
  using namespace brick_wall;
  RunningMean faces, bed_joints, head_joints, above_head_joints;
  for (int course = 0; course < courses; ++course)
    for (int brick = 0; brick < per_course; ++brick) {
      const float shift = course % 2 == 0 ? 0.0f : 0.5f;
      const auto height_at = [&](float along, float down) {
        return bricks_at({(static_cast<float>(brick) + along - shift) / per_course,
                          (static_cast<float>(course) + down) / courses})
            .height;
      };
      faces.add(height_at(0.5f, 0.5f));
      bed_joints.add(height_at(0.5f, 0.0f));
      head_joints.add(height_at(0.0f, 0.5f));
      above_head_joints.add(height_at(0.0f, -0.5f));
    }
  CHECK(faces.mean() - bed_joints.mean() == Approx(depth).epsilon(0.15));
  CHECK(faces.mean() - head_joints.mean() == Approx(depth).epsilon(0.15));
  CHECK(above_head_joints.mean() == Approx(faces.mean()).epsilon(0.15));
}

TEST_CASE("bricks: edges lean outward, so that light from the upper left makes bricks stand out") {
  using namespace brick_wall;
  const int size = 512;
  const TextureMaps maps = lt::bricks(size);
  const auto normal = [&](float u, float v) {
    return decoded(maps, wrap(static_cast<int>(std::floor(u * size)), size),
                   wrap(static_cast<int>(std::floor(v * size)), size));
  };
  vec3 left(0.0f), right(0.0f), top(0.0f), bottom(0.0f);
  const float half_joint = 0.5f * joint / courses;  // an edge's distance from the joint's middle
  for (int course = 0; course < courses; ++course)
    for (int brick = 0; brick < per_course; ++brick) {
      const float shift = course % 2 == 0 ? 0.0f : 0.5f;
      const float u = (static_cast<float>(brick) - shift) / per_course;
      const float v = static_cast<float>(course) / courses;
      const float next_u = u + 1.0f / per_course, next_v = v + 1.0f / courses;
      left += normal(u + half_joint, (v + next_v) / 2);
      right += normal(next_u - half_joint, (v + next_v) / 2);
      top += normal((u + next_u) / 2, v + half_joint);
      bottom += normal((u + next_u) / 2, next_v - half_joint);
    }
  const float count = courses * per_course;
  CHECK(left.x / count < -0.15f);
  CHECK(right.x / count > 0.15f);
  CHECK(top.y / count < -0.15f);
  CHECK(bottom.y / count > 0.15f);
}

TEST_CASE("concrete: each panel has four tie holes, deeper than all else") {
  using namespace concrete_wall;
  for (int row = 0; row < panels.y; ++row)
    for (int column = 0; column < panels.x; ++column)
      for (const vec2 tie : {vec2(0.25f, 0.25f), vec2(0.75f, 0.25f), vec2(0.25f, 0.75f)}) {
        const vec2 uv = (vec2(column, row) + tie) / vec2(panels);
        const float beside = 2.0f * tie_radius;
        CHECK(concrete_at(uv).height <
              concrete_at(uv + vec2(beside, 0.0f)).height - 0.5f * tie_depth);
        CHECK(concrete_at(uv).height <
              concrete_at(uv - vec2(0.0f, beside)).height - 0.5f * tie_depth);
        CHECK(concrete_at(uv).color.x < 0.7f * concrete_at(uv + vec2(beside, 0.0f)).color.x);
      }
}

TEST_CASE("tiles: as many as planned, higher and lighter than the grout between them") {
  using namespace tiled_floor;
  const auto is_tile = [](vec2 uv) { return tiles_at(uv).color.x > 0.5f; };
  CHECK(count_pieces(512, is_tile) == per_side * per_side);
  CHECK(count_pieces(512, std::not_fn(is_tile)) == 1);
  for (int i = 0; i < per_side; ++i) {
    const float middle = (static_cast<float>(i) + 0.5f) / per_side;
    const float joint = static_cast<float>(i) / per_side;
    CHECK(tiles_at({middle, 0.125f}).height > tiles_at({joint, 0.125f}).height + 0.5f * depth);
    CHECK(tiles_at({0.125f, middle}).height > tiles_at({0.125f, joint}).height + 0.5f * depth);
  }
}

TEST_CASE("planks: one board to a row, lying along u, in one net of gaps") {
  using namespace plank_floor;
  const auto is_board = [](vec2 uv) { return planks_at(uv).height > 0.5f * depth; };
  CHECK(count_pieces(512, is_board) == rows * boards);
  CHECK(count_pieces(512, std::not_fn(is_board)) == 1);
}
