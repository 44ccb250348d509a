#include <algorithm>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/entity/entity_pools.h"
#include "engine/anim/entity/entity_run.h"
#include "engine/anim/entity/player.h"
#include "engine/anim/kernel/kernels.h"
#include "tests/anim/asset/clip_fixtures.h"

namespace throng::anim::player_bones_test {
namespace {

/// The number of levels of detail that a bone is part of: `level + 1` as the least selects the prefix of `level`.
std::vector<std::uint8_t> level_priorities(const Skeleton& skeleton) {
  std::vector<std::uint8_t> priorities;
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    const auto levels = std::ranges::count_if(skeleton.level_bone_counts, [&](int count) { return bone < count; });
    priorities.push_back(static_cast<std::uint8_t>(levels));
  }
  return priorities;
}

/// A player a third through a clip, posed as a PU would.
class PlayerInStore {
 public:
  PlayerInStore(const Character& character, StreamKind stream, const BoneSelection* bones)
      : pools_(character.skeleton.bone_count(), character.skeleton.components(), Residency::transient) {
    const BakedClip& clip = character.clips.front();
    clip_ = {.keyframe = clip.keyframe(), .sampled = clip.sampled(), .duration = clip.duration};
    assets_ = {.clips = {&clip_, 1}, .kernels = &scalar_kernels(), .components = character.skeleton.components()};
    const bool sampled = stream == StreamKind::sampled;
    const Handle handle = pools_.create(sampled ? EntityPools::sampled_players : EntityPools::keyframe_players);
    entity_ = {
        .block = pools_.block(handle), .prepared = prepared_, .layout = &pools_.layout(handle), .assets = &assets_};
    auto& player = entity_.as<Player>();
    player.position = clip.duration * fine_ticks_per_tick / 3;
    if (bones != nullptr) {
      assets_.selections = {bones, 1};
      player.bone_selection = 1;
    }
    entity_.layout->kind->advance({.first = entity_});
  }

  void pose_packet(int packet, float* out) const {
    entity_.layout->kind->pose_packet(entity_, {.packet = packet, .out = out});
  }

 private:
  EntityPools pools_;
  ClipStreams clip_;
  EntityAssets assets_;
  alignas(64) std::byte prepared_[most_prepared_bytes]{};
  EntityInStore entity_;
};

/// One character in one pose: its player's packets, and the palette that they give.
class PosedCharacter {
 public:
  PosedCharacter(const Character& character, StreamKind stream, const BoneSelection* bones, int bone_count)
      : skeleton_(character.skeleton),
        bone_count_(bone_count),
        local_(allocate_aligned(pose_bytes(skeleton_.bone_count(), skeleton_.components()))),
        palette_(static_cast<std::size_t>(skeleton_.palette_count())) {
    const PlayerInStore player(character, stream, bones);
    for (int index = 0; index < packets(); ++index) player.pose_packet(index, floats() + packet_floats() * index);
    multiply(character.hierarchy);
  }

  const PaletteMatrix& entry(int index) const { return palette_[static_cast<std::size_t>(index)]; }
  const float* packet(int index) const { return floats() + packet_floats() * index; }

 private:
  float* floats() const { return reinterpret_cast<float*>(local_.get()); }
  std::ptrdiff_t packet_floats() const { return static_cast<std::ptrdiff_t>(skeleton_.components()) * packet_bones; }
  int packets() const { return packets_for(bone_count_); }

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

TEST_P(BonePriorities, SkipAPacketThatHasNoBoneAndTheStreamIsNotRead) {
  std::optional<Character> character = bake_character(synthetic_model(62, 1));
  const BoneSelection none(character->skeleton, level_priorities(character->skeleton), 200);
  const PlayerInStore player(*character, GetParam(), &none);
  character.reset();
  const AlignedBytes pose = allocate_aligned(packet_bytes(rigid_components));
  auto* floats = reinterpret_cast<float*>(pose.get());
  for (int packet = 0; packet < none.packets(); ++packet) {
    EXPECT_EQ(none.lanes(packet), 0) << packet;
    player.pose_packet(packet, floats);
    for (int lane = 0; lane < packet_bones; ++lane) EXPECT_EQ(floats[3 * packet_bones + lane], 1.0F);
  }
}

INSTANTIATE_TEST_SUITE_P(Streams, BonePriorities, testing::Values(StreamKind::sampled, StreamKind::keyframe),
                         [](const auto& stream) {
                           return std::string(stream.param == StreamKind::sampled ? "Sampled" : "Keyframe");
                         });

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
}  // namespace throng::anim::player_bones_test
