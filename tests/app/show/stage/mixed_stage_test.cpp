// A stage on which several characters stand: everybody is posed, bounded, given slots and drawn as the one that they
// are.

#include <algorithm>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "app/show/picture.h"
#include "app/show/stage/stage.h"
#include "app/window/selection_reporter.h"
#include "tests/app/show/stage/watched_stage.h"

namespace throng::app::mixed_stage_test {
namespace {

constexpr const char* mannequin = THRONG_SOURCE_DIR "/assets/mannequin.glb";
constexpr const char* pillar = THRONG_SOURCE_DIR "/tests/data/features/plain.glb";

class MixedStage : public test::WatchedStage {
 protected:
  MixedStage() { open_mixed({.scene = Scene::grid, .agents = 60, .system = {.pus = 2}}); }

  void open_mixed(const Tuning& tuning) {
    std::vector<CharacterSource> characters;
    for (const char* file : {mannequin, pillar}) characters.push_back(*load_character(file, file));
    open(tuning, std::move(characters));
  }
  std::uint64_t hash_after(const Tuning& tuning, int frames) {
    open_mixed(tuning);
    pass(frames);
    return hash();
  }
  std::uint32_t first_of(std::uint8_t character) const {
    const auto characters = stage_->crowd().characters();
    return static_cast<std::uint32_t>(std::ranges::find(characters, character) - characters.begin());
  }
};

TEST_F(MixedStage, EveryAgentIsAnimatedAsItsOwnCharacter) {
  const auto characters = stage_->crowd().characters();
  for (std::uint32_t agent = 0; agent < characters.size(); ++agent) {
    const auto& own = *stage_->characters()[characters[agent]].character;
    EXPECT_EQ(&stage_->system().agent(agent).character(), &own);
    EXPECT_EQ(stage_->character_of(agent).character.get(), &own);
  }
  EXPECT_LT(first_of(1), characters.size());
}

TEST_F(MixedStage, HasOnePoseHashHoweverItIsScheduled) {
  const Tuning base{.scene = Scene::grid, .agents = 60, .system = {.pus = 1}};
  Tuning levels = base, three = base, narrow = base;
  levels.system.schedule = anim::Schedule::levels;
  three.system.pus = 3;
  narrow.system.tile = 2;
  const std::uint64_t expected = hash_after(base, 40);
  for (const Tuning& tuning : {levels, three, narrow}) EXPECT_EQ(hash_after(tuning, 40), expected);
}

TEST_F(MixedStage, SlotsAreAsLargeAsTheCharacterNeeds) {
  open_mixed({.scene = Scene::grid, .agents = 60, .lod = {.rule = LodRule::budget, .bone_lod = false, .smooth = true}});
  pass(2);
  const auto slot_of = [&](std::uint8_t character) {
    return stage_->posed().shown().pose(first_of(character)).to.lines * render::palette_line_bytes;
  };
  EXPECT_EQ(slot_of(0), anim::palette_stride(62, PaletteFormat::matrices));
  const auto few = static_cast<std::uint32_t>(stage_->characters()[1].character->skeleton.palette_count());
  EXPECT_EQ(slot_of(1), anim::palette_stride(few, PaletteFormat::matrices));
}

TEST_F(MixedStage, ThePictureHasRunsOfOneCharacterInAscendingOrder) {
  pass(2);
  Picture picture;
  picture.compose(*stage_);
  ASSERT_EQ(picture.batches().size(), 2U);
  for (const render::CrowdBatch& batch : picture.batches()) {
    for (std::uint32_t i = 0; i < batch.count; ++i) {
      const std::uint32_t agent = picture.instances()[batch.first + i].agent;
      EXPECT_EQ(stage_->crowd().characters()[agent], batch.character);
    }
  }
  EXPECT_LT(picture.batches()[0].character, picture.batches()[1].character);
}

TEST_F(MixedStage, EverybodyFallsWithTheBonesOfTheirOwnCharacter) {
  pass(2);
  for (const std::uint8_t character : {std::uint8_t{0}, std::uint8_t{1}}) {
    const std::uint32_t agent = first_of(character);
    ASSERT_TRUE(stage_->animated().can_fall(agent));
    EXPECT_TRUE(stage_->animated().push_over(agent, {0.0F, 0.0F, 1.0F}));
  }
  const auto lie = [&] {
    return stage_->animated().fallen().hips(first_of(0)).has_value() &&
           stage_->animated().fallen().hips(first_of(1)).has_value();
  };
  for (int i = 0; i < 60 && !lie(); ++i) pass(1);
  EXPECT_TRUE(lie());
}

TEST_F(MixedStage, OtherRolesOfOneCharacterLeaveTheOtherAsItIs) {
  const RoleClips before = stage_->characters()[1].roles.clips;
  RoleClips still = stage_->characters()[0].roles.clips;
  still[index_of(Role::wave)] = no_clip;
  stage_->set_roles(0, still);
  EXPECT_EQ(stage_->characters()[0].roles.clips, still);
  EXPECT_EQ(stage_->characters()[1].roles.clips, before);
  pass(2);
}

}  // namespace
}  // namespace throng::app::mixed_stage_test
