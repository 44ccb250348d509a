// How a picture is composed in tiles.
#include "app/show/picture.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <set>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "throng/heap_pages.h"

#include "app/show/camera/fly_camera.h"
#include "app/show/stage/stage.h"
#include "tests/counting/hot_path_counter.h"

namespace throng::app::picture_test {
namespace {

constexpr Ticks frame = ticks_per_second / 60;
constexpr int agents = 9000;  // more than eight tiles
constexpr const char* pillar = THRONG_SOURCE_DIR "/tests/data/features/plain.glb";

/// A pillar whose clips give the last of so many morphs a weight.
CharacterSource morphing_pillar(std::uint32_t morphs) {
  CharacterSource source = *load_character(pillar, pillar);
  source.model.morphs.resize(morphs);
  const auto metres = static_cast<float>(source.character->bounds.height / 2.0);
  auto& deltas = source.model.meshes.front().morph_deltas;
  for (std::uint32_t morph = 0; morph < morphs; ++morph) {
    deltas.push_back({.vertex = 0, .morph = morph, .position = {0.0F, metres, 0.0F}, .normal = {}});
  }
  for (anim::Clip& clip : source.model.clips) {
    clip.morph_tracks = {{.interpolation = anim::Interpolation::linear,
                          .morphs = {static_cast<int>(morphs) - 1},
                          .times = {0.0F},
                          .weights = {0.5F}}};
  }
  source.character = std::make_shared<const anim::Character>(anim::bake_character(source.model));
  return source;
}

/// A crowd of pillars that morph and pillars that do not, on pages that hold a few hundred each.
class PictureInTiles : public testing::Test {
 protected:
  void open(std::uint32_t morphs) {
    std::vector<CharacterSource> characters;
    characters.push_back(morphing_pillar(morphs));
    characters.push_back(*load_character(pillar, pillar));
    auto made = Stage::create(std::move(characters), tuning_, pages_);
    ASSERT_TRUE(made);
    stage_ = std::move(*made);
    for (std::size_t each = 0; each < 2; ++each) {
      stage_->posed().mesh_lods().set(each, {{}, {0.1F, 0.1F}, {0.2F, 0.2F}}, {300, 100, 30});
    }
    pass();
    ASSERT_GT(stage_->posed().selection().visible.size(), 8200U);
  }
  void pass() {
    stage_->move(frame);
    stage_->pose(camera_, 1280, 720, frame, stage_->posed().frame());
  }
  Picture composed_on(int pus) {
    tuning_.system.pus = pus;
    EXPECT_TRUE(stage_->apply(tuning_));
    Picture picture;
    picture.compose(*stage_);
    return picture;
  }
  /// Dresses most: each wears some of twelve pieces, and two of three, or all, have one of four silhouettes.
  void dress(bool all_have_silhouettes = false) {
    std::vector<render::Outfit> outfits(stage_->crowd().size());
    for (std::uint32_t agent = 0; agent < outfits.size(); ++agent) {
      render::Outfit& outfit = outfits[agent];
      if (agent % 7 == 0) continue;
      for (std::uint16_t piece = 1; piece <= 12; ++piece) {
        if ((agent * 2654435761U >> piece & 1U) != 0) outfit.pieces.at(outfit.count++) = piece;
      }
      if (all_have_silhouettes || agent % 3 != 0) outfit.silhouette = static_cast<std::uint16_t>(13 + agent % 4);
    }
    const auto looks = stage_->crowd().looks().drawn;
    stage_->animated().crowd().looks().wear(looks, std::move(outfits));
    for (std::size_t each = 0; each < 2; ++each) {
      std::vector<render::MeshError> errors(1);
      while (errors.size() < render::largest_mesh_lod_count) {
        errors.push_back({0.02F * static_cast<float>(errors.size()), 0.0F});
      }
      stage_->posed().mesh_lods().set(each, errors, std::vector<std::uint32_t>(errors.size(), 100));
    }
    pass();
  }
  /// Returns what an agent is drawn with at a mesh LOD.
  std::set<std::uint32_t> worn(std::uint32_t agent, int mesh_lod) const {
    const render::Outfit& outfit = stage_->crowd().looks().outfits[agent];
    if (outfit.count == 0) return {0};
    const bool far = mesh_lod >= static_cast<int>(render::first_silhouette_lod);
    if (far && outfit.silhouette != render::Outfit::no_piece) return {outfit.silhouette};
    return {outfit.pieces.begin(), outfit.pieces.begin() + outfit.count};
  }
  static void expect_same(const Picture& picture, const Picture& other, int pus) {
    const auto same = [](const auto& a, const auto& b) {
      return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
    };
    EXPECT_TRUE(same(picture.instances(), other.instances())) << pus;
    EXPECT_TRUE(same(picture.morph_weights(), other.morph_weights())) << pus;
    EXPECT_TRUE(same(picture.drawn(), other.drawn())) << pus;
    ASSERT_EQ(picture.batches().size(), other.batches().size()) << pus;
    for (std::size_t i = 0; i < picture.batches().size(); ++i) {
      const render::CrowdBatch &a = picture.batches()[i], &b = other.batches()[i];
      EXPECT_EQ(std::tie(a.page, a.character, a.piece, a.mesh_lod, a.first, a.count),
                std::tie(b.page, b.character, b.piece, b.mesh_lod, b.first, b.count))
          << pus << " PUs, batch " << i;
    }
  }

  HeapPageSource pages_{std::size_t{1} << 20U};
  Tuning tuning_{
      .scene = Scene::grid, .agents = agents, .lod = {.rule = LodRule::off, .smooth = true}, .system = {.pus = 1}};
  std::unique_ptr<Stage> stage_;
  render::Camera camera_ = camera_at({.x = 0, .y = 60, .z = 130, .yaw = 0, .pitch = -25});
};

TEST_F(PictureInTiles, IsTheSameForAnyNumberOfPus) {
  open(5);
  const Picture alone = composed_on(1);
  std::set<int> lods;
  for (const render::CrowdBatch& batch : alone.batches()) lods.insert(batch.mesh_lod);
  ASSERT_GT(lods.size(), 1U);
  ASSERT_GT(alone.batches().back().page, 3U);
  ASSERT_GT(alone.morph_weights().size(), 10'000U);
  for (const int pus : {2, 3, 8}) expect_same(alone, composed_on(pus), pus);
}

TEST_F(PictureInTiles, HasEverybodyOnceInRunsOfOnePageCharacterAndMesh) {
  open(5);
  const Picture picture = composed_on(3);
  std::set<std::uint32_t> drawn;
  std::uint32_t first = 0;
  for (const render::CrowdBatch& batch : picture.batches()) {
    EXPECT_EQ(batch.first, first);
    first += batch.count;
    std::uint32_t last = 0;
    for (std::uint32_t i = batch.first; i < first; ++i) {
      const std::uint32_t agent = picture.instances()[i].agent;
      EXPECT_TRUE(last < agent || i == batch.first);
      last = agent;
      drawn.insert(agent);
      ASSERT_EQ(stage_->posed().pose_of(agent, Poses::shown).to.page, batch.page);
      ASSERT_EQ(stage_->crowd().characters()[agent], batch.character);
    }
  }
  EXPECT_EQ(first, picture.instances().size());
  EXPECT_EQ(drawn.size(), stage_->posed().selection().visible.size());
}

TEST_F(PictureInTiles, HasOnEachListThoseWhoWearThePiece) {
  open(5);
  EXPECT_TRUE(composed_on(2).drawn().empty()) << "nobody wears any";
  dress();
  const Picture picture = composed_on(3);
  std::vector<std::set<std::uint32_t>> drawn(picture.instances().size());
  std::size_t next = 0, of_silhouettes = 0;
  for (const render::CrowdBatch& list : picture.batches()) {
    ASSERT_EQ(list.first, next);
    next += list.count;
    const auto numbers = picture.drawn().subspan(list.first, list.count);
    EXPECT_TRUE(std::ranges::is_sorted(numbers));
    if (list.stands_in) continue;
    of_silhouettes += list.piece > 12 ? list.count : 0;
    for (const std::uint32_t number : numbers) {
      const std::uint32_t agent = picture.instances()[number].agent;
      EXPECT_TRUE(drawn[number].insert(list.piece).second) << "once";
      ASSERT_TRUE(worn(agent, list.mesh_lod).contains(list.piece));
      ASSERT_EQ(stage_->posed().pose_of(agent, Poses::shown).to.page, list.page);
      ASSERT_EQ(stage_->crowd().characters()[agent], list.character);
    }
  }
  EXPECT_EQ(next, picture.drawn().size());
  EXPECT_GT(of_silhouettes, 1000U);
  for (const render::CrowdBatch& run : picture.runs()) {
    for (std::uint32_t number = run.first; number < run.first + run.count; ++number) {
      ASSERT_EQ(drawn[number], worn(picture.instances()[number].agent, run.mesh_lod));
    }
  }
  for (const int pus : {1, 2, 8}) expect_same(picture, composed_on(pus), pus);
}

TEST_F(PictureInTiles, ListsTheSilhouettesOfThoseWhoAreNearForTheirShadows) {
  open(5);
  dress();
  const Picture without = composed_on(2);
  for (const render::CrowdBatch& list : without.batches()) EXPECT_FALSE(list.stands_in) << "some have none";
  dress(true);
  std::size_t wearers = 0, stand_ins = 0;
  const Picture picture = composed_on(3);
  for (const render::CrowdBatch& run : picture.runs()) {
    for (std::uint32_t number = run.first; number < run.first + run.count; ++number) {
      const render::Outfit& outfit = stage_->crowd().looks().outfits[picture.instances()[number].agent];
      wearers += run.mesh_lod < render::first_silhouette_lod && outfit.count > 0 ? 1 : 0;
    }
  }
  for (const render::CrowdBatch& list : picture.batches()) {
    if (!list.stands_in) continue;
    stand_ins += list.count;
    for (const std::uint32_t number : picture.drawn().subspan(list.first, list.count)) {
      EXPECT_EQ(stage_->crowd().looks().outfits[picture.instances()[number].agent].silhouette, list.piece);
    }
  }
  EXPECT_GT(stand_ins, 100U);
  EXPECT_EQ(stand_ins, wearers);
}

TEST_F(PictureInTiles, HasWeightsOfAllWhoMorphHoweverManyForAnyNumberOfPus) {
  open(100);
  const Picture alone = composed_on(1);
  constexpr std::size_t floats = 100;
  const auto named = std::ranges::count_if(alone.instances(), [](const auto& record) { return record.weights > 0; });
  EXPECT_EQ(alone.morph_weights().size() / floats, static_cast<std::size_t>(named));
  EXPECT_GT(static_cast<std::size_t>(named), stage_->posed().selection().visible.size() / 3);
  for (const int pus : {2, 8}) expect_same(alone, composed_on(pus), pus);
}

TEST_F(PictureInTiles, AllocatesNothingOnceItHasRoom) {
  tuning_.system.pus = 2;
  open(5);
  dress();
  Picture picture;
  for (int i = 0; i < 10; ++i) {  // until there are as many pages as there will be
    pass();
    picture.compose(*stage_);
  }
  for (int i = 0; i < 3; ++i) {
    pass();
    const HotPathCounts before = hot_path_counts();
    picture.compose(*stage_);
    const HotPathCounts counts = hot_path_counts() - before;
    EXPECT_EQ(counts.allocations, 0U);
    EXPECT_EQ(counts.locks, 0U);
  }
}

}  // namespace
}  // namespace throng::app::picture_test
