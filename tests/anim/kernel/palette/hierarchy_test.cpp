#include "engine/anim/kernel/palette/hierarchy.h"

#include <map>
#include <set>

#include <gtest/gtest.h>

#include "tests/anim/kernel/kernel_rig.h"

namespace throng::anim::hierarchy_test {
namespace {

using namespace kernel_rig;

HierarchyProgram compile(const std::vector<int>& parents) { return compile_hierarchy(rigid_skeleton(parents)); }

TEST(HierarchyProgram, OfAChainNeedsNoBranchSlot) {
  const HierarchyProgram program = compile(chain_parents(40));
  EXPECT_EQ(program.slot_count, 0);
  EXPECT_EQ(program.steps[0].load, HierarchyStep::from_root);
  for (std::size_t bone = 1; bone < 40; ++bone) EXPECT_EQ(program.steps[bone].load, HierarchyStep::from_previous);
}

TEST(HierarchyProgram, KeepsABranchPointUntilItsLastChildHasReadIt) {
  // 0 - 1 - 2      3 follows 1, 4 follows 0, 5 follows 4's slot-free chain
  //  \   \- 3
  //   \- 4 - 5
  const HierarchyProgram program = compile({-1, 0, 1, 1, 0, 4});
  const auto& steps = program.steps;
  EXPECT_EQ(program.slot_count, 2);
  EXPECT_EQ(steps[3].load, steps[1].store);
  EXPECT_EQ(steps[4].load, steps[0].store);
  EXPECT_NE(steps[0].store, steps[1].store);
  EXPECT_EQ(steps[2].store, HierarchyStep::no_slot);
  EXPECT_EQ(steps[5].load, HierarchyStep::from_previous);
}

TEST(HierarchyProgram, GivesASlotBackAfterItsLastReader) {
  // Three forks in a row: each is done before the next begins, so one slot serves them all.
  const HierarchyProgram program = compile({-1, 0, 0, 2, 2, 4, 4});
  EXPECT_EQ(program.slot_count, 1);
}

TEST(HierarchyProgram, LoadsForEveryBoneWhatItsParentLeft) {
  const std::vector<int> parents = branching_parents(200);
  const HierarchyProgram program = compile(parents);
  std::map<int, int> holder;  // slot -> bone
  for (int bone = 0; bone < 200; ++bone) {
    const HierarchyStep& step = program.steps[static_cast<std::size_t>(bone)];
    const int parent = parents[static_cast<std::size_t>(bone)];
    int loaded = parent;
    if (step.load >= 0) loaded = holder.at(step.load);
    if (step.load == HierarchyStep::from_previous) loaded = bone - 1;
    if (step.load == HierarchyStep::from_root) loaded = -1;
    ASSERT_EQ(loaded, parent) << bone;
    ASSERT_LT(step.store, program.slot_count);
    if (step.store >= 0) holder[step.store] = bone;
  }
}

TEST(HierarchyProgram, ListsThePaletteEntriesOfEachBone) {
  const Skeleton skeleton = general_skeleton(branching_parents(37));
  const HierarchyProgram program = compile_hierarchy(skeleton);
  for (int entry = 0; entry < skeleton.palette_count(); ++entry) {
    const HierarchyStep& step =
        program.steps[static_cast<std::size_t>(skeleton.palette[static_cast<std::size_t>(entry)].bone)];
    EXPECT_GE(entry, step.first_entry);
    EXPECT_LT(entry, step.first_entry + step.entry_count);
  }
}

TEST(HierarchyProgram, HashesEntriesUnderIndicesThatDoNotDependOnTheBoneOrder) {
  // The same three nodes (7 is the root of 3 and 5), the leaves in either order.
  Skeleton one = rigid_skeleton({-1, 0, 0});
  Skeleton other = one;
  one.bones[0].node = other.bones[0].node = 7;
  one.bones[1].node = other.bones[2].node = 3;
  one.bones[2].node = other.bones[1].node = 5;
  const auto joints = compile_hierarchy(one).skin_joint;
  const auto reordered = compile_hierarchy(other).skin_joint;
  EXPECT_EQ(joints[0], reordered[0]);
  EXPECT_EQ(joints[1], reordered[2]);
  EXPECT_EQ(joints[2], reordered[1]);
  EXPECT_EQ(std::set<std::int16_t>(joints.begin(), joints.end()).size(), 3U);
}

TEST(HierarchyProgram, IsPaddedToWholePackets) {
  const HierarchyProgram rigid = compile(chain_parents(17));
  EXPECT_EQ(rigid.steps.size(), 32U);
  EXPECT_EQ(rigid.to_model_origin.size(), 3U * 32U);
  const HierarchyProgram general = compile_hierarchy(general_skeleton(chain_parents(17)));
  EXPECT_EQ(general.prefixes.size(), 12U * 32U);
  EXPECT_EQ(general.has_prefix.size(), 32U);
}

}  // namespace
}  // namespace throng::anim::hierarchy_test
