#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "throng/render/camera.h"

#include "engine/render/scenery/selection.h"

namespace throng::render::scenery_selection_test {
namespace {

constexpr float picture_height = 720.0F;

/// Two meshes: one of four levels of detail, one of a single level.
std::vector<SceneryShape> shapes() {
  return {{{0.0F, 2.0F, 0.0F}, 3.0F, {0.0F, 0.02F, 0.1F, 0.5F}}, {{0.0F, 0.5F, 0.0F}, 0.6F, {0.0F}}};
}

SceneryInstance at(const glm::vec3& place, std::uint32_t mesh = 0, float scale = 1.0F) {
  SceneryInstance instance{.mesh = mesh};
  for (int axis = 0; axis < 3; ++axis) instance.place[axis] *= scale;
  instance.place[3] = place;
  return instance;
}

CameraView front() {
  Camera camera;
  camera.position = {0.0F, 2.0F, 0.0F};
  return view_of(camera, 16.0F / 9.0F);
}

/// Metres that a pixel is at a distance, in the middle of the picture.
float pixel_at(const CameraView& view, float metres) {
  return 2.0F * metres / (picture_height * view.projection[1][1]);
}

TEST(ScenerySelection, LeavesOutWhatIsOutOfView) {
  const auto all = shapes();
  ScenerySelection selection;
  const std::vector instances{at({0, 0, -20}), at({0, 0, 20}), at({-60, 0, -20}), at({3, 0, -10})};
  const auto order = selection.place(instances, all);
  selection.choose(SceneryView(front(), picture_height));
  std::vector<std::uint32_t> seen;
  for (const std::uint32_t chosen : selection.chosen()) seen.push_back(order[chosen]);
  std::ranges::sort(seen);
  EXPECT_EQ(seen, (std::vector<std::uint32_t>{0, 3}));
}

TEST(ScenerySelection, IsTheCoarsestLevelWhoseErrorIsBelowAPixel) {
  const auto all = shapes();
  for (const float scale : {1.0F, 3.0F}) {
    for (float metres = 6.0F; metres < 1500.0F; metres *= 1.05F) {
      ScenerySelection selection;
      selection.place(std::vector{at({0.0F, 0.0F, -metres * scale}, 0, scale)}, all);
      selection.choose(SceneryView(front(), picture_height));
      if (selection.runs().empty()) continue;  // less than a pixel long
      const std::uint32_t lod = selection.runs()[0].lod;
      const float nearest = glm::distance(glm::vec3(0, 2, 0), glm::vec3(0, 2 * scale, -metres * scale)) - 3.0F * scale;
      const float pixel = pixel_at(front(), nearest);
      EXPECT_LE(all[0].errors[lod] * scale, pixel * scenery_error_pixels * 1.001F) << metres;
      if (lod == 3) continue;
      EXPECT_GT(all[0].errors[lod + 1] * scale, pixel * scenery_error_pixels * 0.999F) << metres;
    }
  }
}

TEST(ScenerySelection, LeavesOutWhatIsLessThanAPixelLong) {
  const auto all = shapes();
  ScenerySelection selection;
  selection.place(std::vector{at({0, 0, -1200}, 1), at({0, 0, -300}, 1)}, all);
  selection.choose(SceneryView(front(), picture_height));
  EXPECT_EQ(selection.chosen().size(), 1U);
}

TEST(ScenerySelection, ChoosesOfManyWhoeverOneWouldChooseOneByOne) {
  const auto all = shapes();
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(-300.0F, 300.0F);
  std::vector<SceneryInstance> instances;
  for (int i = 0; i < 3000; ++i) instances.push_back(at({place(random), 0.0F, place(random)}, i % 2 == 0 ? 0U : 1U));
  ScenerySelection selection;
  const auto order = selection.place(instances, all);
  const SceneryView view(front(), picture_height);
  selection.choose(view);
  std::vector<bool> chosen(instances.size(), false);
  for (const ScenerySelection::Run& run : selection.runs()) {
    for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
      const std::uint32_t instance = order[selection.chosen()[i]];
      EXPECT_EQ(instances[instance].mesh, run.mesh);
      EXPECT_FALSE(chosen[instance]);
      chosen[instance] = true;
    }
  }
  std::size_t in_view = 0;
  for (std::size_t i = 0; i < instances.size(); ++i) {
    const SceneryShape& shape = all[instances[i].mesh];
    const glm::vec3 middle = instances[i].place * glm::vec4(shape.middle, 1.0F);
    const bool is_large = 2.0F * shape.radius >= view.metres_a_pixel(middle, shape.radius) * least_scenery_pixels;
    EXPECT_EQ(chosen[i], view.sees_sphere(middle, shape.radius) && is_large) << i;
    in_view += chosen[i];
  }
  EXPECT_GT(in_view, 300U);
  EXPECT_LT(in_view, 1500U);
}

TEST(ScenerySelection, ComesFromNearToFar) {
  const auto all = shapes();
  std::vector<SceneryInstance> instances;
  for (int i = 0; i < 400; ++i) instances.push_back(at({0.0F, 0.0F, -4.0F - 0.5F * static_cast<float>(i * 151 % 400)}));
  ScenerySelection selection;
  const auto order = selection.place(instances, all);
  selection.choose(SceneryView(front(), picture_height));
  ASSERT_EQ(selection.chosen().size(), instances.size());
  float farthest = 0.0F;
  for (const std::uint32_t chosen : selection.chosen()) {
    const float metres = -instances[order[chosen]].place[3].z;
    EXPECT_GT(1.5F * metres + 3.0F, farthest);  // as exactly as a ring is wide
    farthest = std::max(farthest, metres);
  }
}

TEST(ScenerySelection, AlongParallelRaysGoesByTheSizeOfATexel) {
  const auto all = shapes();
  ScenerySelection selection;
  selection.place(std::vector{at({0, 0, -20}), at({0, 0, 2000})}, all);
  glm::mat4 wide(1.0F);
  wide[0][0] = wide[1][1] = 0.1F;  // 20 metres wide and tall, along z, however near or far
  selection.choose(SceneryView(wide, 0.05F));
  ASSERT_EQ(selection.runs().size(), 1U);
  EXPECT_EQ(selection.runs()[0].lod, 1U);
  EXPECT_EQ(selection.runs()[0].count, 2U);
  selection.choose(SceneryView(wide, 0.05F), 1);
  EXPECT_EQ(selection.runs()[0].lod, 2U) << "one coarser";
}

TEST(ScenerySelection, OfNothingIsNothing) {
  ScenerySelection selection;
  selection.choose(SceneryView(front(), picture_height));
  EXPECT_TRUE(selection.runs().empty());
  selection.place({}, shapes());
  selection.choose(SceneryView(front(), picture_height));
  EXPECT_TRUE(selection.runs().empty());
}

}  // namespace
}  // namespace throng::render::scenery_selection_test
