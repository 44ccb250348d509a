// A host shows a crowd with the library alone.
#include "engine/crowd/system_view.h"

#include <cstring>
#include <memory>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "throng/heap_pages.h"

#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/bake/character.h"
#include "engine/crowd/sorted_draws.h"

namespace throng::system_view_test {
namespace {

constexpr Ticks frame_time = ticks_per_second / 60;
constexpr std::uint32_t agents = 400;
constexpr float spacing = 4.0F;  // metres

std::shared_ptr<const anim::Character> person() {
  static const auto character =
      std::make_shared<const anim::Character>(anim::bake_character(anim::synthetic_model(40, 2)));
  return character;
}

/// Agents in a square, seen from one side by a camera on the ground that looks along +Z.
class SeenCrowd {
 public:
  explicit SeenCrowd(int pus) : system_(std::move(*anim::AnimationSystem::create(person(), {.pus = pus}))) {
    system_->set_agent_count(agents);
    for (std::uint32_t agent = 0; agent < agents; ++agent) {
      system_->agent(agent).play({.clip = static_cast<int>(agent % 2)});
      positions_.emplace_back(spacing * (static_cast<float>(agent % 20) - 10.0F), 0.0F,
                              spacing * static_cast<float>(agent / 20U + 1));
    }
    view_.reset(agents, frame().rules.lod);
    view_.mesh_lods().set(0, {{}, {0.004F, 0.004F}, {0.02F, 0.02F}}, {1000, 300, 50});
  }

  SystemFrame frame() const {
    constexpr float tall = 720.0F;
    SystemFrame seen;
    seen.agents = {.positions = positions_, .headings = headings_, .scales = scales_, .characters = characters_};
    seen.rules.lod = {.rule = LodRule::distance, .interval_growth = 8.0F, .smooth = true};
    seen.view = glm::lookAt(glm::vec3(0.0F, 1.7F, 0.0F), glm::vec3(0.0F, 1.7F, 1.0F), glm::vec3(0.0F, 1.0F, 0.0F));
    seen.projection = glm::perspective(0.9F, 16.0F / 9.0F, 0.1F, 500.0F);
    seen.size = {1280.0F, tall};
    seen.step = frame_time;
    seen.completed = view_.frame();
    seen.camera = {.position = {0.0F, 1.7F, 0.0F},
                   .forward = {0.0F, 0.0F, 1.0F},
                   .frustum = {{{0.0F, 0.0F, 1.0F, 0.0F}}},
                   .pixels_per_unit = seen.projection[1][1] * tall / 2.0F};
    return seen;
  }
  void pass(int frames) {
    for (int i = 0; i < frames; ++i) {
      system_->advance(frame_time);
      const SystemFrame seen = frame();
      view_.choose(*system_, seen);
      posed_ = view_.updates().size();
      for (PoseRequest& update : view_.updates()) {
        if (view_.level_of_detail().is_visible(update.agent.number)) view_.show(*system_, seen, update);
      }
      view_.pose(*system_, seen);
    }
    draws_.compose(view_, *system_, {.agents = frame().agents});
  }

  const SystemView& view() const { return view_; }
  const SortedDraws& draws() const { return draws_; }
  std::size_t posed() const { return posed_; }

 private:
  HeapPageSource pages_{std::size_t{4} << 20U};
  std::unique_ptr<anim::AnimationSystem> system_;
  std::vector<glm::vec3> positions_;
  std::vector<Heading> headings_ = std::vector<Heading>(agents);
  std::vector<float> scales_ = std::vector<float>(agents, 1.0F);
  std::vector<std::uint8_t> characters_ = std::vector<std::uint8_t>(agents, 0);
  SystemView view_{{{.character = person()}}, pages_};
  SortedDraws draws_;
  std::size_t posed_ = 0;
};

TEST(SeenCrowds, AreDrawnWholeInAHandfulOfBatchesFromTheNearestMeshToTheFarthest) {
  SeenCrowd crowd(1);
  crowd.pass(30);
  EXPECT_EQ(crowd.draws().instances().size(), agents);
  ASSERT_EQ(crowd.draws().batches().size(), 3U) << "one for each mesh LOD";
  std::size_t drawn = 0;
  for (const render::CrowdBatch& batch : crowd.draws().batches()) drawn += batch.count;
  EXPECT_EQ(drawn, agents);
  EXPECT_EQ(crowd.draws().batches().front().mesh_lod, 0);
}

TEST(SeenCrowds, SkipUpdatesOfAgentsFarOffAndBlendThem) {
  SeenCrowd crowd(1);
  crowd.pass(30);
  EXPECT_LT(crowd.posed(), agents / 2);
  std::size_t blended = 0;
  for (const render::InstanceRecord& record : crowd.draws().instances()) {
    if (record.blend_duration > 0) ++blended;
    EXPECT_EQ(record.blend_duration > 0, record.palette_from != record.palette_to) << record.agent;
  }
  EXPECT_GT(blended, agents / 4);
}

TEST(SeenCrowds, AreOffByFewPixelsAsTheMeterSays) {
  SeenCrowd crowd(1);
  crowd.pass(60);
  const anim::ErrorFigures& error = crowd.view().error_meter().figures();
  EXPECT_GT(error.samples, 100U);
  EXPECT_GT(error.max, 0.0F) << "skipped updates and coarser meshes are seen";
  EXPECT_GE(error.max, error.p50);
}

TEST(SeenCrowds, AreTheSameForAnyNumberOfPus) {
  SeenCrowd one(1), three(3);
  one.pass(20);
  three.pass(20);
  const auto a = one.draws().instances(), b = three.draws().instances();
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size_bytes()), 0);
}

}  // namespace
}  // namespace throng::system_view_test
