#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/asset/character.h"
#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/entity/player.h"
#include "engine/anim/kernel/kernels.h"
#include "tests/anim/asset/clip_fixtures.h"

namespace throng::anim {
namespace {

/// As a PU would, from what `advance` prepared.
void pose_packet(const PlayerPose& pose, const Kernels& kernels, int components, int packet, float* out) {
  alignas(64) std::byte prepared[64];
  std::memcpy(prepared, &pose, sizeof pose);
  const EntityAssets assets{
      .clips = {}, .masks = {}, .selections = {}, .kernels = &kernels, .bone_count = 0, .components = components};
  const EntityInStore entity{.block = nullptr, .prepared = prepared, .layout = nullptr, .assets = &assets};
  const bool sampled = pose.interpolations.empty();
  (sampled ? sampled_player_kind : keyframe_player_kind).pose_packet(entity, {.packet = packet, .out = out});
}

/// One character in one pose: its player's packets, and the palette that they give.
class PosedCharacter {
 public:
  PosedCharacter(const Character& character, StreamKind stream, const BoneSelection* bones, int bone_count)
      : skeleton_(character.skeleton),
        bone_count_(bone_count),
        local_(allocate_aligned(pose_bytes(skeleton_.bone_count(), skeleton_.components()))),
        palette_(static_cast<std::size_t>(skeleton_.palette_count())) {
    pose(character.clips.front(), stream, bones);
    multiply(character.hierarchy);
  }

  const PaletteMatrix& entry(int index) const { return palette_[static_cast<std::size_t>(index)]; }
  const float* packet(int index) const { return floats() + packet_floats() * index; }

 private:
  float* floats() const { return reinterpret_cast<float*>(local_.get()); }
  std::ptrdiff_t packet_floats() const { return static_cast<std::ptrdiff_t>(skeleton_.components()) * packet_bones; }
  int packets() const { return packets_for(bone_count_); }

  void pose(const BakedClip& clip, StreamKind stream, const BoneSelection* bones) {
    const ClipStreams streams{.keyframe = &clip.keyframe(), .sampled = clip.sampled(), .duration = clip.duration};
    Player player{};
    player.state.type = stream == StreamKind::sampled ? EntityType::sampled_player : EntityType::keyframe_player;
    player.position = clip.duration * fine_ticks_per_tick / 3;
    std::vector<std::byte> interpolations(interpolation_bytes(skeleton_.bone_count(), skeleton_.components()));
    PlayerPose pose = begin_pose(player, streams, interpolations);
    pose.bones = bones;
    for (int index = 0; index < packets(); ++index) {
      pose_packet(pose, scalar_kernels(), skeleton_.components(), index, floats() + packet_floats() * index);
    }
  }

  void multiply(const HierarchyProgram& hierarchy) {
    constexpr auto line = static_cast<std::size_t>(branch_slot_floats) * sizeof(float);
    const AlignedBytes carry = allocate_aligned(line);
    const AlignedBytes slots = allocate_aligned(line * static_cast<std::size_t>(hierarchy.slot_count + 1));
    const PaletteDestination palette = palette_.data();
    for (int index = 0; index < packets(); ++index) {
      scalar_kernels().model_palette({.hierarchy = &hierarchy,
                                      .packet = index,
                                      .bone_count = bone_count_,
                                      .width = 1,
                                      .characters = 1,
                                      .local = packet(index),
                                      .carry = reinterpret_cast<float*>(carry.get()),
                                      .branch_slots = reinterpret_cast<float*>(slots.get()),
                                      .palettes = &palette});
    }
  }

  const Skeleton& skeleton_;
  int bone_count_;
  AlignedBytes local_;
  std::vector<PaletteMatrix> palette_;
};

float largest_difference(const PaletteMatrix& a, const PaletteMatrix& b) {
  float largest = 0.0F;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      largest = std::max(largest, std::abs(a.rows[row][column] - b.rows[row][column]));
    }
  }
  return largest;
}

class BonePriorities : public testing::TestWithParam<StreamKind> {
 protected:
  PosedCharacter pose(const BoneSelection* bones, int bone_count) const {
    return {character_, GetParam(), bones, bone_count};
  }
  PosedCharacter whole_pose(const BoneSelection* bones) const { return pose(bones, skeleton().bone_count()); }
  const Skeleton& skeleton() const { return character_.skeleton; }
  int levels() const { return static_cast<int>(skeleton().level_bone_counts.size()); }

  const Character character_ = bake_character(synthetic_model(62, 1));
};

TEST_P(BonePriorities, OfTheLevelOrderGiveThePaletteOfThePrefixToTheBit) {
  ASSERT_GE(levels(), 3);
  for (int level = 0; level < levels(); ++level) {
    const BoneSelection bones(skeleton(), level_priorities(skeleton()), static_cast<std::uint8_t>(level + 1));
    const int kept = skeleton().level_bone_counts[static_cast<std::size_t>(level)];
    EXPECT_EQ(bones.evaluated_bones(), kept);
    const PosedCharacter selected = whole_pose(&bones);
    const PosedCharacter prefix = pose(nullptr, kept);
    for (int entry = 0; entry < kept; ++entry) {
      ASSERT_EQ(std::memcmp(&selected.entry(entry), &prefix.entry(entry), sizeof(PaletteMatrix)), 0)
          << "level " << level << " entry " << entry;
    }
    for (int entry = kept; entry < skeleton().bone_count(); ++entry) {
      const int followed = nearest_kept_bone(skeleton(), entry, kept);
      EXPECT_LT(largest_difference(selected.entry(entry), prefix.entry(followed)), 2e-6F) << entry;
    }
  }
}

TEST_P(BonePriorities, LeaveTheBonesBelowADroppedOneMoving) {
  const int dropped = skeleton().bones[40].parent;
  std::vector<std::uint8_t> priorities(skeleton().bones.size(), 1);
  priorities[static_cast<std::size_t>(dropped)] = 0;
  const BoneSelection bones(skeleton(), priorities, 1);
  const PosedCharacter selected = whole_pose(&bones);
  const PosedCharacter all = whole_pose(nullptr);
  for (int bone = 0; bone < skeleton().bone_count(); ++bone) {
    for (int component = 0; component < skeleton().components(); ++component) {
      const int place = component * packet_bones + bone % packet_bones;
      const float expected = bone != dropped ? all.packet(bone / packet_bones)[place] : component == 3 ? 1.0F : 0.0F;
      ASSERT_EQ(selected.packet(bone / packet_bones)[place], expected) << bone << " " << component;
    }
  }
  EXPECT_LT(largest_difference(selected.entry(dropped),
                               selected.entry(skeleton().bones[static_cast<std::size_t>(dropped)].parent)),
            2e-6F);
}

TEST_P(BonePriorities, ThatSelectEveryBoneChangeNothing) {
  const BoneSelection bones(skeleton(), level_priorities(skeleton()), 0);
  const PosedCharacter selected = whole_pose(&bones);
  const PosedCharacter all = whole_pose(nullptr);
  for (int packet = 0; packet < bones.packets(); ++packet) {
    EXPECT_EQ(bones.lanes(packet), 0xFFFF);
    EXPECT_EQ(std::memcmp(selected.packet(packet), all.packet(packet), packet_bytes(skeleton().components())), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Streams, BonePriorities, testing::Values(StreamKind::sampled, StreamKind::keyframe),
                         [](const auto& stream) {
                           return std::string(stream.param == StreamKind::sampled ? "Sampled" : "Keyframe");
                         });

TEST(BoneSelection, SkipsAPacketThatHasNoBoneAndTheStreamIsNotRead) {
  const Character character = bake_character(synthetic_model(62, 1));
  const BoneSelection none(character.skeleton, level_priorities(character.skeleton), 200);
  const AlignedBytes pose = allocate_aligned(packet_bytes(rigid_components));
  auto* floats = reinterpret_cast<float*>(pose.get());
  for (int packet = 0; packet < none.packets(); ++packet) {
    EXPECT_EQ(none.lanes(packet), 0) << packet;
    PlayerPose without_stream;
    without_stream.bones = &none;
    pose_packet(without_stream, scalar_kernels(), rigid_components, packet, floats);
    for (int lane = 0; lane < packet_bones; ++lane) EXPECT_EQ(floats[3 * packet_bones + lane], 1.0F);
  }
}

TEST(BoneSelection, KeepsTheRestTransformOfADroppedBoneOnTheGeneralPath) {
  const Model model = general_model(20);
  const BoneSelection none(model.skeleton, std::vector<std::uint8_t>(20, 0), 1);
  for (int bone = 0; bone < 20; ++bone) {
    const float* lane = none.still(bone / packet_bones) + bone % packet_bones;
    const Transform& rest = model.skeleton.bones[static_cast<std::size_t>(bone)].rest;
    EXPECT_FLOAT_EQ(lane[4 * packet_bones], rest.translation.x);
    EXPECT_FLOAT_EQ(lane[9 * packet_bones], rest.scale.z);
  }
}

}  // namespace
}  // namespace throng::anim
