// A host shows a crowd with the public headers alone.
#include "throng/crowd_view.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "throng/heap_pages.h"

#include "engine/anim/api/character_data.h"
#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/bake/character.h"
#include "tests/anim/agent/heard_misuses.h"

namespace throng::crowd_view_test {
namespace {

constexpr Ticks frame_time = ticks_per_second / 60;
constexpr float spacing = 4.0F;  // metres

Character person(int bones = 40) {
  const anim::Model model = anim::synthetic_model(bones, 2);
  return detail::character_of(anim::bake_character(model),
                              std::make_shared<const detail::CharacterBody>(model, std::nullopt, false));
}

/// Agents in a row that leads away from a camera, which looks along +Z.
struct CrowdViewTest : testing::Test {
  std::uint32_t add(std::uint32_t count, CharacterId character = 0) {
    for (const AgentId agent : crowd.add_agents(count, character)) crowd.agent(agent).play({.clip = {0}});
    positions.resize(crowd.number_limit());
    for (std::size_t i = 0; i < positions.size(); ++i) positions[i].z = spacing * static_cast<float>(i + 1);
    return crowd.number_limit();
  }
  ViewFrame frame() const {
    ViewFrame seen{.positions = positions, .frame_step = frame_time, .completed = view.frame()};
    seen.camera.forward = {0.0F, 0.0F, 1.0F};
    seen.camera.frustum = {{{0.0F, 0.0F, 1.0F, 0.0F}}};  // all before the camera
    seen.rules.lod.rule = LodRule::distance;
    seen.projection.columns[3][3] = 0.0F, seen.projection.columns[2][3] = 1.0F;  // the depth divides
    return seen;
  }
  void pass(int frames = 1) {
    for (int i = 0; i < frames; ++i) {
      crowd.advance(frame_time);
      posed = view.choose(crowd, frame()).size();
      view.pose(crowd);
      draws = view.draws(crowd);
    }
  }
  std::set<std::uint32_t> drawn() const {
    std::set<std::uint32_t> agents;
    for (const render::InstanceRecord& record : draws.instances) agents.insert(record.agent);
    return agents;
  }

  HeapPageSource pages{std::size_t{1} << 20U};
  Crowd crowd = std::move(*Crowd::create(person()));
  CrowdView view{pages};
  std::vector<Vec3> positions;
  std::size_t posed = 0;
  CrowdDraws draws;
};

TEST_F(CrowdViewTest, DrawsEachAgentInView) {
  add(100);
  positions[7].z = -5.0F;  // behind the camera
  pass();
  EXPECT_EQ(draws.instances.size(), 99U);
  EXPECT_FALSE(drawn().contains(7));
  EXPECT_FALSE(view.is_visible({7}));
  ASSERT_EQ(draws.batches.size(), 1U);
  EXPECT_EQ(draws.batches.front().count, 99U);
}

TEST_F(CrowdViewTest, WritesThePaletteThatAnInstanceNames) {
  add(3);
  pass();
  std::vector<float> own(crowd.palette_bytes(0) / sizeof(float) + 4);
  for (const render::InstanceRecord& record : draws.instances) {
    auto* const exact = reinterpret_cast<std::byte*>((reinterpret_cast<std::uintptr_t>(own.data()) + 15) / 16 * 16);
    const PoseRequest request{.agent = {record.agent}, .palette = exact};
    crowd.pose_exactly({&request, 1});
    const std::byte* const shown =
        pages.memory(draws.batches.front().page) + record.palette_to * render::palette_line_bytes;
    EXPECT_EQ(std::memcmp(shown, exact, 48 * crowd.character(0).palette_entries()), 0) << record.agent;
  }
}

TEST_F(CrowdViewTest, PosesFarAgentsMoreSeldomAndBlendsThem) {
  add(100);
  pass(30);
  EXPECT_LT(posed, 50U);
  const auto blends = [](const render::InstanceRecord& record) { return record.blend_duration > 0; };
  EXPECT_GT(std::ranges::count_if(draws.instances, blends), 50);
}

TEST_F(CrowdViewTest, DrawsAnAgentThatWasAddedAtOnceAndARemovedOneNoMore) {
  add(10);
  pass(5);
  ASSERT_TRUE(crowd.remove_agent({3}));
  pass();
  EXPECT_FALSE(drawn().contains(3));
  EXPECT_EQ(draws.instances.size(), 9U);
  add(200);
  pass();
  EXPECT_EQ(draws.instances.size(), 209U);
}

TEST_F(CrowdViewTest, DrawsNoAgentThatPlaysNothing) {
  add(2);
  crowd.add_agent();
  positions.resize(crowd.number_limit(), {0.0F, 0.0F, spacing});
  const anim::HeardMisuses heard;
  pass();
  EXPECT_EQ(drawn(), (std::set<std::uint32_t>{0, 1}));
}

TEST_F(CrowdViewTest, ShowsCharactersThatComeLater) {
  add(5);
  pass(3);
  const auto other = crowd.add(person(60));
  ASSERT_TRUE(other) << other.error().message;
  add(5, *other);
  pass(2);
  EXPECT_EQ(draws.instances.size(), 10U);
  ASSERT_EQ(draws.batches.size(), 2U);
  EXPECT_EQ(draws.batches.back().character, 1);
}

TEST_F(CrowdViewTest, GivesFarAgentsTheCoarserMeshWhoseErrorIsNotSeen) {
  const render::MeshError errors[] = {{}, {0.01F, 0.01F}};
  const std::uint32_t triangles[] = {1000, 100};
  ASSERT_TRUE(view.set_mesh_lods(0, {errors, triangles}));
  add(100);
  pass();
  ASSERT_EQ(draws.batches.size(), 2U);
  EXPECT_EQ(draws.batches.front().mesh_lod, 0);
  EXPECT_EQ(draws.batches.back().mesh_lod, 1);
  EXPECT_EQ(view.figures().triangles, 1000U * draws.batches.front().count + 100U * draws.batches.back().count);
}

TEST_F(CrowdViewTest, WritesNoPaletteAnewThatAFrameInFlightMayRead) {
  add(1);
  std::set<std::uint32_t> written;
  for (int i = 0; i < 20; ++i) {
    crowd.advance(frame_time);
    ViewFrame seen = frame();
    seen.completed = 0;  // the device has finished no frame
    view.choose(crowd, seen);
    view.pose(crowd);
    EXPECT_TRUE(written.insert(view.draws(crowd).instances.front().palette_to).second) << "in frame " << i;
  }
}

TEST_F(CrowdViewTest, SaysThatMemoryGrowsIfNoFrameIsEverCompleted) {
  add(1);
  const anim::HeardMisuses heard;
  for (int i = 0; i < 100; ++i) {
    crowd.advance(frame_time);
    ViewFrame seen = frame();
    seen.completed = 0;
    view.choose(crowd, seen);
    view.pose(crowd);
  }
  EXPECT_EQ(heard.all(), (std::vector<std::string>{"CrowdView::choose: ViewFrame::completed has stayed 0, so no memory "
                                                   "of palettes is written again"}));
}

TEST_F(CrowdViewTest, MeasuresTheErrorOfWhatIsShown) {
  add(200);
  pass(60);
  EXPECT_GT(view.figures().error_samples, 100U);
  EXPECT_GT(view.figures().error_max, 0.0F);
  EXPECT_LE(view.figures().error_p99, view.figures().error_max);
  EXPECT_EQ(view.figures().agents_in_view, 200U);
}

TEST_F(CrowdViewTest, MeasuresNoErrorWithoutTheMatricesOfThePicture) {
  add(200);
  for (int i = 0; i < 60; ++i) {
    crowd.advance(frame_time);
    ViewFrame seen = frame();
    seen.projection = {};
    view.choose(crowd, seen);
    view.pose(crowd);
  }
  EXPECT_EQ(view.figures().error_samples, 0U);
}

TEST_F(CrowdViewTest, SaysWhatIsWrongWithACall) {
  add(10);
  const anim::HeardMisuses heard;
  view.pose(crowd);
  EXPECT_EQ(heard.all().back(), "CrowdView::pose: there was no choice since the last call");
  positions.resize(5);
  EXPECT_TRUE(view.choose(crowd, frame()).empty());
  EXPECT_EQ(heard.all().back(), "CrowdView::choose: the frame's positions have no place for each agent's number");
  const render::MeshError error{};
  EXPECT_EQ(view.set_mesh_lods(0, {.errors = {&error, 1}}).error().message,
            "CrowdView::set_mesh_lods: a character has 1 to 7 meshes, each with an error and a number of triangles");
}

}  // namespace
}  // namespace throng::crowd_view_test
