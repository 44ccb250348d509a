#include "engine/anim/asset/skeleton_order.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::anim::skeleton_order_test {
namespace {

using ::testing::ElementsAre;

/// A trunk of eight bones with two hands of eight fingers that matter little; handles of the rig matter nothing.
struct TwoHands {
  std::vector<int> parents;
  std::vector<double> importance;

  TwoHands() {
    for (int bone = 0; bone < 8; ++bone) add(bone - 1, 1.0);
    for (int hand = 0; hand < 2; ++hand) {
      const int wrist = add(7, 0.4);
      for (int finger = 0; finger < 8; ++finger) add(wrist, 0.05);
    }
    add(0, 0.0);
  }

  int add(int parent, double matters) {
    parents.push_back(parent);
    importance.push_back(matters);
    return static_cast<int>(parents.size()) - 1;
  }
};

std::vector<int> kept(const BoneOrder& order, int count) {
  std::vector<int> bones(order.bones.begin(), order.bones.begin() + count);
  std::ranges::sort(bones);
  return bones;
}

TEST(BoneOrder, HoldsEveryBoneOnceAfterItsParent) {
  const TwoHands rig;
  const BoneOrder order = order_bones(rig.parents, rig.importance);
  ASSERT_EQ(order.bones.size(), rig.parents.size());
  std::vector<bool> seen(rig.parents.size(), false);
  for (const int bone : order.bones) {
    const int parent = rig.parents[static_cast<std::size_t>(bone)];
    EXPECT_TRUE(parent < 0 || seen[static_cast<std::size_t>(parent)]);
    EXPECT_FALSE(seen[static_cast<std::size_t>(bone)]);
    seen[static_cast<std::size_t>(bone)] = true;
  }
}

TEST(BoneOrder, DropsTheFingersOfBothHandsTogetherAndKeepsTheHands) {
  const TwoHands rig;
  const BoneOrder order = order_bones(rig.parents, rig.importance);
  EXPECT_THAT(order.level_counts, ElementsAre(27, 10));
  EXPECT_THAT(kept(order, 10), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8, 17));
}

TEST(BoneOrder, WalksDepthFirstInsideALevel) {
  //   0 - 1 - 3
  //     \ 2 - 4
  const std::vector<int> parents{-1, 0, 0, 1, 2};
  const std::vector<double> importance(5, 1.0);
  const BoneOrder order = order_bones(parents, importance);
  EXPECT_THAT(order.bones, ElementsAre(0, 1, 3, 2, 4));
  EXPECT_THAT(order.level_counts, ElementsAre(5));
}

TEST(BoneOrder, NeverDropsAnUnimportantParentBeforeItsChild) {
  std::vector<int> parents{-1};
  std::vector<double> importance{0.0};
  for (int bone = 1; bone < 20; ++bone) {
    parents.push_back(bone % 2 == 1 ? 0 : bone - 1);
    importance.push_back(bone % 2 == 1 ? 0.0 : 1.0 / bone);
  }
  const BoneOrder order = order_bones(parents, importance);
  for (const int count : order.level_counts) {
    const std::vector<int> bones = kept(order, count);
    for (const int bone : bones) {
      const int parent = parents[static_cast<std::size_t>(bone)];
      EXPECT_TRUE(parent < 0 || std::ranges::binary_search(bones, parent));
    }
  }
}

TEST(BoneOrder, KeepsEveryRootInEveryLevelHoweverLittleItMoves) {
  TwoHands rig;
  const int still = rig.add(-1, 0.0);
  const BoneOrder order = order_bones(rig.parents, rig.importance);
  ASSERT_GT(order.level_counts.size(), 1U);
  EXPECT_THAT(kept(order, order.level_counts.back()), ::testing::Contains(still));
}

TEST(ReorderBones, KeepsWhatEveryIndexNames) {
  Model model;
  for (int bone = 0; bone < 3; ++bone) {
    Bone made;
    made.node = 10 + bone;
    made.parent = bone == 0 ? -1 : 0;
    model.skeleton.bones.push_back(made);
    model.skeleton.references.emplace_back();
    model.skeleton.palette.push_back({.bone = bone});
  }
  Skin skin;
  skin.bones = {2, 1, 0};
  skin.palette_entries = {2, 1, 0};
  model.skins.push_back(skin);
  Clip clip;
  clip.tracks.resize(2);
  clip.tracks[0].bone = 1;
  clip.tracks[1].bone = 2;
  clip.tracks[1].rotation.times = {0.0F};
  model.clips.push_back(clip);
  SkinnedMesh mesh;
  mesh.palette_entries = {glm::u16vec4(0, 1, 2, 2)};
  model.meshes.push_back(mesh);

  reorder_bones(model, {.bones = {0, 2, 1}, .level_counts = {3, 2}});

  EXPECT_EQ(model.skeleton.bones[1].node, 12);
  EXPECT_THAT(model.skins[0].bones, ElementsAre(1, 2, 0));
  EXPECT_THAT(model.skins[0].palette_entries, ElementsAre(1, 2, 0));
  EXPECT_EQ(model.clips[0].tracks[0].bone, 1);
  EXPECT_FALSE(model.clips[0].tracks[0].rotation.empty());
  EXPECT_EQ(model.meshes[0].palette_entries[0], glm::u16vec4(0, 2, 1, 1));
  EXPECT_THAT(model.skeleton.level_bone_counts, ElementsAre(3, 2));
}

}  // namespace
}  // namespace throng::anim::skeleton_order_test
