#include "engine/anim/asset/keyframe_stream.h"

#include <algorithm>
#include <cstdint>

#include <gtest/gtest.h>

#include "engine/anim/asset/synthetic_model.h"
#include "tests/anim/asset/clip_fixtures.h"

namespace throng::anim::keyframe_stream_test {
namespace {

const glm::quat turned = glm::angleAxis(0.7F, glm::vec3(0.0F, 0.0F, 1.0F));

TEST(KeyframeStream, IsOneAlignedBlock) {
  const Model model = synthetic_model(62, 1);
  const AlignedBytes block = build_keyframe_stream(model.skeleton, model.clips.front());
  const KeyframeStream& stream = stream_in(block);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block.get()) % 64, 0U);
  EXPECT_EQ(stream.total_size % 64, 0U);
  EXPECT_EQ(stream.constants_offset, sizeof(KeyframeStream));
  for (const std::uint32_t offset : stream.values_offsets) EXPECT_LE(offset, stream.total_size);
}

TEST(KeyframeStream, HoldsTheRestPoseOfAClipWithoutTracks) {
  const Model model = synthetic_model(20, 1);
  const AlignedBytes block = build_keyframe_stream(model.skeleton, Clip{});
  const KeyframeStream& stream = stream_in(block);
  EXPECT_EQ(stream.event_count, 0U);
  TestPlayer player(stream);
  const std::vector<float> pose = player.pose_at(Ticks{});
  for (int bone = 0; bone < 2 * packet_bones; ++bone) {
    for (int c = 0; c < rigid_components; ++c) {
      EXPECT_NEAR(component_of(pose, rigid_components, bone, c), c == 3 ? 1.0F : 0.0F, 1e-6F) << bone << ' ' << c;
    }
  }
}

TEST(KeyframeStream, DropsTracksThatDoNotMove) {
  const Model model = one_bone_model();
  BoneTracks tracks;
  tracks.translation = sampled_track([](float) { return glm::vec3(1.0F, 2.0F, 3.0F); }, 30.0, 30);
  tracks.rotation = {Interpolation::linear, {0.0F, 0.5F, 1.0F}, {turned, -turned, turned}};
  const AlignedBytes block = build_keyframe_stream(model.skeleton, one_bone_clip(tracks, 1.0));
  const KeyframeStream& stream = stream_in(block);
  EXPECT_EQ(stream.track_count, 0U);
  TestPlayer player(stream);
  const std::vector<float> pose = player.pose_at(ticks_per_second / 3);
  EXPECT_FLOAT_EQ(component_of(pose, rigid_components, 0, 2), turned.z);
  EXPECT_FLOAT_EQ(component_of(pose, rigid_components, 0, 6), 3.0F);
}

TEST(KeyframeStream, KeepsACubicTrackWhoseValuesAgreeButWhoseTangentsDoNot) {
  const Model model = one_bone_model();
  const glm::vec3 none(0.0F);
  BoneTracks tracks;
  tracks.translation = {
      Interpolation::cubic_spline, {0.0F, 1.0F}, {none, none, glm::vec3(1.0F, 0.0F, 0.0F), none, none, none}};
  const AlignedBytes block = build_keyframe_stream(model.skeleton, one_bone_clip(tracks, 1.0));
  TestPlayer player(stream_in(block));
  EXPECT_NEAR(component_of(player.pose_at(ticks_per_second / 2), rigid_components, 0, 4), 0.125F, 1e-6F);
}

TEST(KeyframeStream, SortsKeysAsAForwardPlayerNeedsThem) {
  const Model model = synthetic_model(30, 1);
  const Clip clip = wild_clip(model.skeleton, Interpolation::linear, 2.0, 3);
  const AlignedBytes block = build_keyframe_stream(model.skeleton, clip);
  const KeyframeStream& stream = stream_in(block);
  const auto later = stream.events().subspan(stream.track_count);
  EXPECT_TRUE(std::ranges::is_sorted(later, {}, &KeyEvent::start));
  std::size_t keys = 0;
  for (const BoneTracks& tracks : clip.tracks) keys += tracks.rotation.times.size() + tracks.translation.times.size();
  EXPECT_EQ(stream.event_count, keys - stream.track_count) << "an event a segment";
}

TEST(KeyframeStream, ReadsValuesOfEachChannelFromFrontToBack) {
  const Model model = synthetic_model(30, 1);
  const AlignedBytes block =
      build_keyframe_stream(model.skeleton, wild_clip(model.skeleton, Interpolation::linear, 2.0, 3));
  std::uint32_t last[key_channels] = {};
  for (const KeyEvent& event : stream_in(block).events()) {
    std::uint32_t& before = last[static_cast<int>(event.channel)];
    EXPECT_GT(event.value, before);
    EXPECT_LT(event.previous_value, event.value);
    before = event.value;
  }
}

TEST(KeyframeStream, HasASeekPointEverySoManyEvents) {
  const Model model = synthetic_model(30, 1);
  const AlignedBytes block =
      build_keyframe_stream(model.skeleton, wild_clip(model.skeleton, Interpolation::linear, 2.0, 3));
  const KeyframeStream& stream = stream_in(block);
  const std::uint32_t later = stream.event_count - stream.track_count;
  ASSERT_GT(later, 2 * stream.seek_interval) << "the clip is too short to show anything";
  const auto events = stream.events();
  for (std::uint32_t point = 0; point <= later / stream.seek_interval; ++point) {
    const std::uint32_t met = stream.track_count + point * stream.seek_interval;
    const auto latest = stream.seek_point(point);
    for (std::uint32_t track = 0; track < stream.track_count; ++track) {
      ASSERT_LT(latest[track], met);
      const auto newer = std::ranges::find_if(
          events.subspan(latest[track] + 1, met - latest[track] - 1),
          [&](const KeyEvent& e) { return e.bone == events[track].bone && e.channel == events[track].channel; });
      EXPECT_EQ(newer, events.subspan(0, met).end()) << "seek point " << point << " is behind on track " << track;
    }
  }
}

}  // namespace
}  // namespace throng::anim::keyframe_stream_test
