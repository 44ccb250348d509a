// Clips are loaded and unloaded while others play, through the public headers.

#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/api/character_data.h"
#include "engine/anim/api/crowd_parts.h"
#include "tests/anim/agent/heard_misuses.h"
#include "tests/api/api_crowd.h"

namespace throng::clips_test {
namespace {

using anim::HeardMisuses;
using api_test::ApiCrowd;
using api_test::mannequin;

constexpr Ticks fade = ticks_per_second / 5;
constexpr const char* unloaded = "the character has no clip of this id: it was unloaded";

/// Returns the character without this clip.
Character without(const Character& character, const char* name) {
  const auto made = character.without(character.find_clip(name));
  EXPECT_TRUE(made) << made.error().message;
  return *made;
}

/// Returns a file of its own, which has this clip of the mannequin alone.
Character file_of(const char* name) {
  Character file = load(THRONG_SOURCE_DIR "/assets/mannequin.glb")->characters.front();
  for (std::uint32_t clip = 0; clip < file.clip_count(); ++clip) {
    if (file.clip({clip}).name != name) file = *file.without({clip});
  }
  return file;
}

Character with(const Character& character, const Character& more) {
  const auto made = character.with_clips(more);
  EXPECT_TRUE(made) << (made ? "" : made.error().message);
  return *made;
}

bool are_alike(const ApiCrowd& a, const ApiCrowd& b, AgentId agent) {
  const std::size_t floats = 12 * std::size_t{mannequin().palette_entries()};
  return std::memcmp(a.palette(agent), b.palette(agent), floats * sizeof(float)) == 0;
}

TEST(LoadedClips, TakeTheEmptyPlacesAndAreFoundByName) {
  const Character less = without(mannequin(), "wave");
  EXPECT_EQ(less.clip_count(), mannequin().clip_count()) << "places are counted";
  const ClipId gone = mannequin().find_clip("wave");
  EXPECT_TRUE(mannequin().has(gone));
  EXPECT_FALSE(less.has(gone));
  EXPECT_FALSE(less.has({gone.number})) << "its place is empty";
  EXPECT_TRUE(less.clip(gone).name.empty());
  EXPECT_FALSE(less.find_clip("wave").valid());
  EXPECT_FALSE(less.find_clip("").valid());

  const Character again = with(less, file_of("wave"));
  const ClipId back = again.find_clip("wave");
  EXPECT_EQ(back.number, gone.number);
  EXPECT_NE(back, gone);
  EXPECT_TRUE(again.has(back));
  EXPECT_TRUE(again.has({gone.number}));
  EXPECT_FALSE(again.has(gone)) << "another clip is there";
  EXPECT_EQ(again.clip(back).duration, mannequin().clip(gone).duration);
}

TEST(LoadedClips, ShareTheSurfaceAndTheRigs) {
  const Character less = without(mannequin(), "wave");
  ASSERT_GT(less.mesh_count(), 0U);
  EXPECT_EQ(less.mesh(0).positions.data(), mannequin().mesh(0).positions.data());
  EXPECT_EQ(less.missing_rigs().data(), mannequin().missing_rigs().data());
}

TEST(LoadedClips, OfAnotherSkeletonAreRefusedInWords) {
  const HeardMisuses heard;
  EXPECT_FALSE(Character().with_clips(mannequin()));
  EXPECT_FALSE(mannequin().with_clips(Character()));
  EXPECT_FALSE(Character().without({0}));
  EXPECT_EQ(HeardMisuses::all().size(), 3U);
  const auto none = mannequin().without({9999});
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().message.find("has no clip of this id"), std::string::npos);
  const auto twice = mannequin().with_clips(mannequin());
  ASSERT_FALSE(twice);
  EXPECT_NE(twice.error().message.find("already"), std::string::npos);
}

TEST(LoadedClips, PlayWhileTheOthersShowTheSameBits) {
  const Character less = without(mannequin(), "wave");
  ApiCrowd quiet(6), changing(6);
  ASSERT_TRUE(changing->replace(0, less));
  for (ApiCrowd* crowd : {&quiet, &changing}) {
    for (std::uint32_t agent = 0; agent < 6; ++agent) {
      crowd->agent(agent).play({.clip = less.find_clip(agent % 2 == 0 ? "walk" : "idle")});
    }
    crowd->step(5);
    crowd->agent(2).play({.clip = less.find_clip("idle"), .fade = fade});
    crowd->step(3);
  }
  const Character more = with(less, file_of("wave"));
  const Status replaced = changing->replace(0, more);
  ASSERT_TRUE(replaced) << replaced.error().message;
  EXPECT_TRUE(changing->character(0).has(more.find_clip("wave")));
  EXPECT_TRUE(changing.agent(5).play({.clip = more.find_clip("wave"), .fade = fade}));
  EXPECT_TRUE(quiet.agent(5).play({.clip = mannequin().find_clip("wave"), .fade = fade}));
  for (int frame = 0; frame < 20; ++frame) {
    quiet.step();
    changing.step();
    for (const AgentId agent : quiet->agents()) ASSERT_TRUE(are_alike(quiet, changing, agent)) << agent.number;
  }
}

TEST(UnloadedClips, AreRefusedByTheirIdsInEveryRequest) {
  const ClipId wave = mannequin().find_clip("wave"), idle = mannequin().find_clip("idle");
  ApiCrowd crowd(1);
  ASSERT_TRUE(crowd->replace(0, without(mannequin(), "wave")));
  ASSERT_TRUE(crowd->replace(0, with(crowd->character(0), file_of("wave"))));
  Agent agent = crowd.agent(0);
  ASSERT_TRUE(agent.play({.clip = idle}));
  const ChannelId slot = *agent.add_slot(), layer = *agent.add_clips();
  const BlendPoint line[] = {{.clip = idle}, {.clip = wave, .parameter = 1.0F}};
  const BlendPoint2d plane[] = {{.clip = idle}, {.clip = wave, .x = 1.0F}};
  const auto machine = StateMachine::parse(R"({"states": [{"name": "greet", "clip": "wave"}]})", mannequin());
  ASSERT_TRUE(machine);
  const HeardMisuses heard;
  EXPECT_FALSE(agent.add(*machine)) << "it was made for a character that had the clip";
  EXPECT_FALSE(agent.play({.clip = wave}));
  EXPECT_FALSE(agent.play(layer, {.clip = wave}));
  EXPECT_FALSE(agent.play_once(slot, {.clip = wave}));
  EXPECT_FALSE(agent.add(BlendSpace{.points = line}));
  EXPECT_FALSE(agent.add(BlendSpace2d{.points = plane}));
  ASSERT_EQ(HeardMisuses::all().size(), 6U);
  for (const std::string& misuse : HeardMisuses::all()) EXPECT_NE(misuse.find(unloaded), std::string::npos) << misuse;
  EXPECT_TRUE(agent.play({.clip = crowd->character(0).find_clip("wave")}));
  EXPECT_TRUE(agent.play({.clip = {wave.number}})) << "a number names whichever is there";
}

TEST(UnloadedClips, StayWhileAgentsPlayThem) {
  ApiCrowd crowd(3);
  const ClipId wave = mannequin().find_clip("wave"), walk = mannequin().find_clip("walk");
  for (std::uint32_t agent = 0; agent < 3; ++agent) crowd.agent(agent).play({.clip = wave});
  crowd.step();
  const Character less = without(mannequin(), "wave");
  const Status refused = crowd->replace(0, less);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "3 agents play \"wave\": let them play something else first");
  EXPECT_TRUE(crowd->character(0).has(wave));
  for (std::uint32_t agent = 0; agent < 3; ++agent) crowd.agent(agent).play({.clip = walk, .fade = fade});
  crowd.step(20);
  EXPECT_TRUE(crowd->replace(0, less));
  EXPECT_FALSE(crowd->character(0).has(wave));
}

TEST(UnloadedClips, LeaveNoNoteForLevelOfDetail) {
  ApiCrowd crowd(2);
  crowd.agent(0).play({.clip = mannequin().find_clip("wave")});
  crowd.agent(1).play({.clip = mannequin().find_clip("idle")});
  crowd.step();
  ASSERT_TRUE(crowd.agent(0).remove(ChannelId{0}));
  ASSERT_TRUE(crowd->replace(0, without(mannequin(), "wave")));
  EXPECT_EQ(crowd->parts().notes.clips[0], -1);
  EXPECT_EQ(crowd->parts().notes.clips[1], static_cast<int>(mannequin().find_clip("idle").number));
  Lod lod;
  const std::vector<Vec3> positions(2);
  EXPECT_EQ(lod.select(*crowd, {.positions = positions, .frame_step = ticks_per_second / 60}).size(), 2U);
}

TEST(UnloadedClips, ReturnInEventsUnderTheIdThatTheyHaveNow) {
  ApiCrowd crowd(1);
  ASSERT_TRUE(crowd->replace(0, without(mannequin(), "wave")));
  ASSERT_TRUE(crowd->replace(0, with(crowd->character(0), file_of("wave"))));
  const ClipId wave = crowd->character(0).find_clip("wave");
  EXPECT_EQ(wave.generation, 1U);
  crowd.agent(0).play({.clip = wave, .loop = false});
  crowd.step();
  const Ticks before = crowd->clock();
  crowd->advance(20 * ticks_per_second);
  int ends = 0;
  crowd.agent(0).motion().for_each_end(before, crowd->clock(), [&](const ClipEnd& end) {
    EXPECT_EQ(end.clip, wave);
    ++ends;
  });
  EXPECT_EQ(ends, 1);
}

TEST(UnloadedClips, LetGoOfTheirFile) {
  ApiCrowd crowd(1);
  crowd.agent(0).play({.clip = mannequin().find_clip("idle")});
  ASSERT_TRUE(crowd->replace(0, without(mannequin(), "wave")));
  std::weak_ptr<const anim::Character> file;
  Snapshot snapshot;
  {
    const Character loaded = file_of("wave");
    file = loaded.data()->baked;
    ASSERT_TRUE(crowd->replace(0, with(crowd->character(0), loaded)));
  }
  const std::weak_ptr<const void> streams =
      crowd->character(0).data()->baked->clips[crowd->character(0).find_clip("wave").number].lender;
  EXPECT_FALSE(streams.expired());
  crowd->snapshot(snapshot);
  ASSERT_TRUE(crowd->replace(0, without(crowd->character(0), "wave")));
  EXPECT_FALSE(streams.expired()) << "a snapshot knows the clip";
  EXPECT_FALSE(crowd->restore(snapshot)) << "and cannot be restored";
  crowd->snapshot(snapshot);
  EXPECT_TRUE(streams.expired());
  EXPECT_TRUE(file.expired());
  EXPECT_TRUE(crowd->restore(snapshot));
}

TEST(UnloadedClips, GoWithCharactersThatWereMadeOfTheCrowdsAlone) {
  ApiCrowd crowd(1);
  const Character stranger = load(THRONG_SOURCE_DIR "/assets/mannequin.glb")->characters.front();
  const Status refused = crowd->replace(0, stranger);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("was not made of the character"), std::string::npos);
  ASSERT_TRUE(crowd->replace(0, without(mannequin(), "wave")));
  EXPECT_FALSE(crowd->replace(0, mannequin())) << "an older one: ids would name other clips in the next";
  EXPECT_FALSE(crowd->replace(0, without(mannequin(), "clap")));
  const HeardMisuses heard;
  EXPECT_FALSE(crowd->replace(0, Character()));
  EXPECT_FALSE(crowd->replace(3, mannequin()));
  EXPECT_EQ(HeardMisuses::all().size(), 2U);
}

TEST(UnloadedClips, LeaveRigsWhereTheyAre) {
  ApiCrowd crowd(1);
  crowd.agent(0).play({.clip = mannequin().find_clip("idle")});
  const auto gaze = crowd.agent(0).add(LookAt{});
  ASSERT_TRUE(gaze) << gaze.error().message;
  ASSERT_TRUE(crowd->replace(0, without(mannequin(), "wave")));
  EXPECT_TRUE(crowd.agent(0).processes().look_at(*gaze, {1.0F, 1.0F, 1.0F}));
  EXPECT_TRUE(crowd.agent(0).add(Reach{.limb = Limb::right_arm}));
  crowd.step(5);
}

}  // namespace
}  // namespace throng::clips_test
