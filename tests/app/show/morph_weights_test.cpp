#include "engine/crowd/morph_weights.h"

#include <algorithm>
#include <memory>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "throng/heap_pages.h"

#include "app/show/camera/fly_camera.h"
#include "app/show/picture.h"
#include "app/show/stage/stage.h"

namespace throng::app::morph_weights_test {
namespace {

constexpr Ticks frame = ticks_per_second / 60;

CharacterSource plain_pillar() {
  const std::string file = THRONG_SOURCE_DIR "/tests/data/features/plain.glb";
  return *load_character(file, file);
}

/// A pillar that five morphs lift by half of its height. Its clips give the last one a weight of `weight`.
CharacterSource morphing_pillar(float weight) {
  CharacterSource source = plain_pillar();
  source.model.morphs.resize(5);
  const auto metres = static_cast<float>(source.character->bounds.height / 2.0);
  source.model.meshes.front().morph_deltas = {
      {.vertex = 0, .morph = 4, .position = {0.0F, metres, 0.0F}, .normal = {}}};
  for (anim::Clip& clip : source.model.clips) {
    clip.morph_tracks = {
        {.interpolation = anim::Interpolation::linear, .morphs = {4}, .times = {0.0F}, .weights = {weight}}};
  }
  source.character = std::make_shared<const anim::Character>(anim::bake_character(source.model));
  return source;
}

class PictureOfMorphs : public testing::Test {
 protected:
  void open(std::vector<CharacterSource> characters) {
    const Tuning tuning{
        .scene = Scene::grid, .agents = 40, .lod = {.rule = LodRule::off, .smooth = true}, .system = {.pus = 1}};
    auto made = Stage::create(std::move(characters), tuning, pages_);
    ASSERT_TRUE(made);
    stage_ = std::move(*made);
  }
  /// Composes the picture that the camera sees from so far behind the crowd.
  void compose(float metres) {
    camera_.position.z = metres;
    stage_->move(frame);
    stage_->pose(camera_, 1280, 720, frame, stage_->posed().frame());
    picture_.compose(*stage_);
    ASSERT_FALSE(picture_.instances().empty());
  }
  static std::uint32_t place_of(const render::InstanceRecord& record) { return record.weights; }
  std::size_t morphing() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(picture_.instances(), [](const auto& record) { return place_of(record) > 0; }));
  }

  HeapPageSource pages_{std::size_t{1} << 20U};
  std::unique_ptr<Stage> stage_;
  Picture picture_;
  render::Camera camera_ = camera_at({.x = 0, .y = 4, .z = 25, .yaw = 0, .pitch = -10});
};

TEST_F(PictureOfMorphs, HasTheWeightsOfEveryAgentWhoseCharacterMorphs) {
  open({morphing_pillar(0.5F), plain_pillar()});
  compose(25);
  std::set<std::uint32_t> places;
  for (const render::InstanceRecord& record : picture_.instances()) {
    const bool morphs = stage_->crowd().characters()[record.agent] == 0;
    EXPECT_EQ(place_of(record) > 0, morphs);
    if (!morphs || place_of(record) == 0) continue;
    places.insert(place_of(record));
    const std::size_t first = place_of(record) - 1;
    ASSERT_LT(first + 4, picture_.morph_weights().size());
    EXPECT_EQ(picture_.morph_weights()[first + 4], 0.5F);
    EXPECT_EQ(picture_.morph_weights()[first + 3], 0.0F);
  }
  EXPECT_GT(places.size(), 1U);
  EXPECT_EQ(places.size(), morphing()) << "no two agents share weights";
  const std::size_t bytes = picture_.morph_weights().size();
  compose(25);
  EXPECT_EQ(picture_.morph_weights().size(), bytes) << "a picture begins anew";
}

TEST_F(PictureOfMorphs, HasNoWeightsOfThoseTooSmallToTell) {
  open({morphing_pillar(0.5F)});
  compose(25);
  EXPECT_EQ(morphing(), picture_.instances().size());
  compose(4000);  // a pillar of a third of a pixel
  EXPECT_EQ(morphing(), 0U);
  EXPECT_TRUE(picture_.morph_weights().empty());
}

TEST_F(PictureOfMorphs, HasNoWeightsWhereAllRest) {
  open({plain_pillar()});
  compose(25);
  EXPECT_TRUE(picture_.morph_weights().empty());
}

}  // namespace
}  // namespace throng::app::morph_weights_test
