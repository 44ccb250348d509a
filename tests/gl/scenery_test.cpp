#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/gl/doll_crowd.h"
#include "tests/gl/gl_test.h"

namespace throng::render::test::scenery_test {
namespace {

struct Colour {
  std::uint8_t red, green, blue;
};
constexpr Colour red{200, 8, 8}, green{8, 160, 8};

/// A disc of so many corners that faces +Z, one metre in radius, about the origin.
void add_disc(SceneryMeshData& mesh, int corners, float error, const Colour& colour) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const auto corner_at = [](float angle) { return glm::vec2(std::cos(angle), std::sin(angle)); };
  for (int i = 0; i < corners; ++i) {
    const glm::vec2 at = corner_at(6.2831853F * static_cast<float>(i) / static_cast<float>(corners));
    mesh.vertices.push_back({.position = {at.x, at.y, 0.0F},
                             .normal = {0.0F, 0.0F, 1.0F},
                             .color = {colour.red, colour.green, colour.blue, 255}});
  }
  SceneryLodData& lod = mesh.lods.emplace_back();
  lod.error = error;
  for (std::uint32_t i = 1; i + 1 < static_cast<std::uint32_t>(corners); ++i) {
    lod.indices.insert(lod.indices.end(), {first, first + i, first + i + 1});
  }
}

SceneryMeshData disc(const char* name, const Colour& colour) {
  SceneryMeshData mesh{.name = name, .vertices = {}, .lods = {}};
  // The error of an inscribed polygon is what it lacks in the middle of a side.
  for (const int corners : {96, 16}) {
    add_disc(mesh, corners, corners == 96 ? 0.0F : 1.0F - std::cos(3.14159265F / 16.0F), colour);
  }
  return mesh;
}

SceneryInstance at(const glm::vec3& place, std::uint32_t mesh) {
  SceneryInstance instance{.mesh = mesh};
  instance.place[3] = place;
  return instance;
}

class Scenery : public SoftwareGlTest {
 protected:
  void SetUp() override {
    SoftwareGlTest::SetUp();
    if (HasFatalFailure()) return;
    crowd_ = std::make_unique<DollCrowd>(context());
    const std::vector meshes{disc("red", red), disc("green", green)};
    ASSERT_TRUE(renderer().load_scenery(meshes));
  }

  Renderer& renderer() { return crowd_->renderer(); }
  DollCrowd& crowd() { return *crowd_; }

  /// A frame without a crowd, from eye level along -Z, under an overcast sky.
  CrowdFrame empty_frame() {
    CrowdFrame frame = crowd().frame();
    frame.instances = {};
    frame.batches = {};
    Camera camera;
    camera.position = {0.0F, 1.6F, 0.0F};
    frame.camera = view_of(camera, static_cast<float>(DollCrowd::width) / DollCrowd::height);
    frame.light.clouds = 1.0F;
    frame.shadows = frame.crowd_shade = false;
    frame.scenery = true;
    return frame;
  }
  Image drawn(const CrowdFrame& frame) {
    counts_ = renderer().draw(frame);
    EXPECT_TRUE(renderer().finish());
    return renderer().read_image();
  }
  const DrawCounts& counts() const { return counts_; }

  static int pixels(const Image& image, int strong, int weak) {
    int count = 0;
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        const auto pixel = image.pixel(x, y);
        count += pixel[strong] > 60 && pixel[strong] > 2 * pixel[weak] ? 1 : 0;
      }
    }
    return count;
  }
  static int red_pixels(const Image& image) { return pixels(image, 0, 1); }
  static int green_pixels(const Image& image) { return pixels(image, 1, 0); }

 private:
  std::unique_ptr<DollCrowd> crowd_;
  DrawCounts counts_;
};

TEST_F(Scenery, IsDrawnWhereTheFrameAsksForIt) {
  renderer().place_scenery(std::vector{at({0.0F, 1.6F, -6.0F}, 0)});
  CrowdFrame frame = empty_frame();
  EXPECT_GT(red_pixels(drawn(frame)), 500);
  const DrawCounts with = counts();
  frame.scenery = false;
  EXPECT_EQ(red_pixels(drawn(frame)), 0);
  EXPECT_EQ(with.draw_calls, counts().draw_calls + 1) << "what scatters light; nothing mirrors";
  EXPECT_GE(with.triangles, counts().triangles + 14);
}

TEST_F(Scenery, TakesNoMoreCallsHoweverMuchStandsThere) {
  renderer().place_scenery(std::vector{at({0.0F, 1.6F, -6.0F}, 0)});
  drawn(empty_frame());
  const std::uint32_t calls = counts().draw_calls;
  std::vector<SceneryInstance> many;
  for (int i = 0; i < 500; ++i)
    many.push_back(
        at({static_cast<float>(i % 20 - 10), 1.0F, -5.0F - static_cast<float>(i / 20)}, i % 2 == 0 ? 0U : 1U));
  renderer().place_scenery(many);
  const Image image = drawn(empty_frame());
  EXPECT_EQ(counts().draw_calls, calls);
  EXPECT_GT(red_pixels(image), 100);
  EXPECT_GT(green_pixels(image), 100);
}

TEST_F(Scenery, IsHiddenByWhatIsNearer) {
  for (const std::uint32_t near : {0U, 1U}) {  // whichever of the two is drawn first
    renderer().place_scenery(std::vector{at({0.0F, 1.6F, -4.0F}, near), at({0.0F, 1.6F, -6.0F}, 1 - near)});
    const Image image = drawn(empty_frame());
    EXPECT_EQ(near == 0 ? green_pixels(image) : red_pixels(image), 0);
    EXPECT_GT(near == 0 ? red_pixels(image) : green_pixels(image), 500);
  }
}

TEST_F(Scenery, HidesTheCrowdBehindIt) {
  crowd().stand(1);
  crowd().write_palettes();
  CrowdFrame frame = crowd().frame();
  frame.shadows = frame.crowd_shade = false;
  const Image without = drawn(frame);
  const glm::vec3 eye = frame.camera.position;
  const auto& record = crowd().instances[0];
  const glm::vec3 chest =
      glm::vec3(record.position[0], record.position[1], record.position[2]) + glm::vec3(0.0F, 1.0F, 0.0F);
  SceneryInstance wall = at(glm::mix(eye, chest, 0.6F), 1);
  for (int axis = 0; axis < 3; ++axis) wall.place[axis] *= 4.0F;
  renderer().place_scenery(std::vector{wall});
  frame.scenery = true;
  const Image hidden = drawn(frame);
  frame.instances = {};
  frame.batches = {};
  const Image alone = drawn(frame);
  EXPECT_TRUE(std::ranges::equal(hidden.rgba, alone.rgba)) << "somebody shows through the wall";
  EXPECT_FALSE(std::ranges::equal(hidden.rgba, without.rgba));
}

TEST_F(Scenery, OutOfViewCostsNoTriangle) {
  renderer().place_scenery(std::vector{at({0.0F, 1.6F, 6.0F}, 0), at({60.0F, 1.6F, -6.0F}, 1)});
  CrowdFrame frame = empty_frame();
  drawn(frame);
  const DrawCounts with = counts();
  frame.scenery = false;
  drawn(frame);
  EXPECT_EQ(with.triangles, counts().triangles);
  EXPECT_EQ(with.draw_calls, counts().draw_calls);
}

TEST_F(Scenery, ChangesByLessThanAPixelWhereItsLevelChanges) {
  CrowdFrame frame = empty_frame();
  std::uint64_t triangles = 0;
  int switches = 0;
  int before = 0;
  for (float metres = 2.0F; metres < 12.0F; metres *= 1.01F) {
    renderer().place_scenery(std::vector{at({0.0F, 1.6F, -metres}, 0)});
    const int area = red_pixels(drawn(frame));
    const float radius = std::sqrt(static_cast<float>(area) / 3.14159265F);
    if (triangles != 0 && counts().triangles != triangles) {
      ++switches;
      const float radius_before = std::sqrt(static_cast<float>(before) / 3.14159265F);
      EXPECT_LT(std::abs(radius_before - radius), 1.0F + 0.011F * radius) << "at " << metres << " metres";
    }
    triangles = counts().triangles;
    before = area;
  }
  EXPECT_EQ(switches, 1);
}

TEST_F(Scenery, IsDrawnOnlyInThePartThatIsAskedFor) {
  renderer().place_scenery(std::vector{at({-1.0F, 1.6F, -4.0F}, 0), at({1.0F, 1.6F, -4.0F}, 1)});
  const Image whole = drawn(empty_frame());
  constexpr PixelRect left{{0, 40}, {DollCrowd::width / 2, DollCrowd::height - 40}};
  renderer().draw_only(left, 0xFF281C10);
  const Image part = drawn(empty_frame());
  const int end = DollCrowd::height - left.corner.y;  // rows are counted from the top
  for (int y = 0; y < part.height; ++y) {
    for (int x = 0; x < part.width; ++x) {
      const auto pixel = part.pixel(x, y), same = whole.pixel(x, y);
      const bool is_in = x < left.size.x && y < end;
      ASSERT_EQ(pixel[0], is_in ? same[0] : 0x10) << x << ", " << y;
      ASSERT_EQ(pixel[2], is_in ? same[2] : 0x28) << x << ", " << y;
    }
  }
  EXPECT_GT(red_pixels(part), 500);
}

TEST_F(Scenery, LooksAsItDidWhereItsVerticesAreLit) {
  const std::vector meshes{disc("red", red)};
  SceneryInstance from_behind = at({1.2F, 1.6F, -5.0F}, 0);
  from_behind.place[0] *= -1.0F;
  from_behind.place[2] *= -1.0F;
  const std::vector instances{at({-1.2F, 1.6F, -5.0F}, 0), from_behind};
  CrowdFrame frame = empty_frame();
  frame.light = {.sun_elevation = 35.0F, .sun_azimuth = 0.0F, .clouds = 0.0F};
  RendererOptions options{
      .data = THRONG_SOURCE_DIR, .size = {DollCrowd::width, DollCrowd::height}, .lights_at_vertices = true};
  auto swift = Renderer::create(context(), options);
  ASSERT_TRUE(swift);
  const CrowdMeshData doll = crowd().doll().mesh_data();
  ASSERT_TRUE((*swift)->load_characters({&doll, 1}));
  for (Renderer* each : {&renderer(), swift->get()}) {
    ASSERT_TRUE(each->load_scenery(meshes));
    each->place_scenery(instances);
  }
  const Image exact = drawn(frame);
  (*swift)->draw(frame);
  ASSERT_TRUE((*swift)->finish());
  const Image& quick = (*swift)->read_image();
  for (std::size_t i = 0; i < exact.rgba.size(); ++i) ASSERT_NEAR(exact.rgba[i], quick.rgba[i], 2) << i / 4;
  EXPECT_GT(red_pixels(exact), 500);
}

TEST_F(Scenery, TintMultipliesOnlyWhatIsTinted) {
  SceneryMeshData grey = disc("grey", {160, 160, 160}), tinted = grey;
  for (SceneryVertex& vertex : tinted.vertices) vertex.tinted = 255;
  ASSERT_TRUE(renderer().load_scenery(std::vector{grey, tinted}));
  SceneryInstance plain = at({-1.5F, 1.6F, -6.0F}, 0), dyed = at({1.5F, 1.6F, -6.0F}, 1);
  plain.tint = dyed.tint = 0xFF0000FF;  // red
  renderer().place_scenery(std::vector{plain});
  EXPECT_EQ(red_pixels(drawn(empty_frame())), 0);
  renderer().place_scenery(std::vector{dyed});
  EXPECT_GT(red_pixels(drawn(empty_frame())), 500);
}

TEST_F(Scenery, GlowsAtNight) {
  SceneryMeshData lamp = disc("lamp", {160, 160, 160});
  for (SceneryVertex& vertex : lamp.vertices) vertex.glow = 255;
  ASSERT_TRUE(renderer().load_scenery(std::vector{lamp, disc("wall", {160, 160, 160})}));
  CrowdFrame frame = empty_frame();
  frame.light.sun_elevation = -20.0F;
  const auto brightness = [&](std::uint32_t mesh) {
    renderer().place_scenery(std::vector{at({0.0F, 1.6F, -6.0F}, mesh)});
    return static_cast<int>(drawn(frame).pixel(DollCrowd::width / 2, DollCrowd::height / 2)[1]);
  };
  EXPECT_GT(brightness(0), brightness(1) + 60);
}

TEST_F(Scenery, CastsShadowsOnTheGround) {
  CrowdFrame frame = empty_frame();
  frame.light = {.sun_elevation = 45.0F, .sun_azimuth = 0.0F, .clouds = 0.0F};  // from behind the disc's front
  renderer().place_scenery(std::vector{at({0.0F, 1.2F, -6.0F}, 0)});
  const Image without = drawn(frame);
  frame.shadows = true;
  const Image with = drawn(frame);
  int darker = 0;
  for (int y = 0; y < with.height; ++y) {
    for (int x = 0; x < with.width; ++x) darker += with.pixel(x, y)[1] + 25 < without.pixel(x, y)[1] ? 1 : 0;
  }
  EXPECT_GT(darker, 100);
}

}  // namespace
}  // namespace throng::render::test::scenery_test
