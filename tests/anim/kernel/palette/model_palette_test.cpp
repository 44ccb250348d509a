#include <algorithm>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "engine/anim/kernel/palette/palette_hash.h"
#include "tests/anim/kernel/palette/palette_rig.h"
#include "tests/anim/kernel/validity.h"

namespace throng::anim::model_palette_test {
namespace {

using namespace kernel_rig;

/// One strip and a bit, so that the last strip of every width is partly filled.
std::vector<LocalPose> random_poses(const Skeleton& skeleton, int count = 19) {
  std::vector<LocalPose> poses;
  for (int i = 0; i < count; ++i) poses.push_back(random_pose(skeleton, static_cast<unsigned>(i)));
  return poses;
}

std::vector<StatePose> states(const Skeleton& skeleton, const std::vector<LocalPose>& poses) {
  std::vector<StatePose> states;
  for (const LocalPose& pose : poses) states.emplace_back(skeleton, pose);
  return states;
}

double largest_error(const Skeleton& skeleton, const std::vector<LocalPose>& poses, const CrowdResult& result) {
  double largest = 0.0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    largest = std::max(largest,
                       kernel_rig::largest_error(skeleton, reference_palette(skeleton, poses[i]), result.palettes[i]));
  }
  return largest;
}

struct Rig {
  std::string name;
  Skeleton skeleton;
};

std::ostream& operator<<(std::ostream& out, const Rig& rig) { return out << rig.name; }

class ModelPalette : public ::testing::TestWithParam<Rig> {
 protected:
  const Skeleton& skeleton() const { return GetParam().skeleton; }
  const HierarchyProgram program_ = compile_hierarchy(GetParam().skeleton);
  const std::vector<LocalPose> poses_ = random_poses(GetParam().skeleton);
  const std::vector<StatePose> states_ = states(GetParam().skeleton, poses_);
  CrowdResult compute(const Kernels& kernels, int width) const {
    return compute_palettes(kernels, program_, states_, width, skeleton().bone_count());
  }
};

constexpr int all_widths[] = {1, 2, 4, 8, 16};

TEST(ModelPaletteJob, IsValidAsItsCommentsSay) {
  static const HierarchyProgram program = compile_hierarchy(rigid_skeleton(branching_parents(20)));
  static const HierarchyProgram general = compile_hierarchy(general_skeleton(branching_parents(20)));
  alignas(64) static std::array<float, 4096> memory{};
  static const std::array<PaletteDestination, 2> palettes{
      PaletteDestination(reinterpret_cast<std::byte*>(memory.data())), nullptr};
  const ModelPaletteJob job{.hierarchy = &program,
                            .packet = 1,
                            .bone_count = program.bone_count,
                            .width = 2,
                            .characters = 1,
                            .local = memory.data(),
                            .carry = memory.data(),
                            .branch_slots = memory.data(),
                            .palettes = palettes.data()};
  expect_validity<ModelPaletteJob>(
      job, {{false, "no hierarchy", [](ModelPaletteJob& job) { job.hierarchy = nullptr; }},
            {false, "a negative packet", [](ModelPaletteJob& job) { job.packet = -1; }},
            {false, "more bones than the skeleton has", [](ModelPaletteJob& job) { job.bone_count = 21; }},
            {false, "an odd width", [](ModelPaletteJob& job) { job.width = 3; }},
            {false, "nobody", [](ModelPaletteJob& job) { job.characters = 0; }},
            {false, "more characters than the width", [](ModelPaletteJob& job) { job.characters = 3; }},
            {false, "a character without a palette", [](ModelPaletteJob& job) { job.characters = 2; }},
            {false, "no palettes", [](ModelPaletteJob& job) { job.palettes = nullptr; }},
            {false, "no local", [](ModelPaletteJob& job) { job.local = nullptr; }},
            {false, "local off the alignment", [](ModelPaletteJob& job) { job.local += 4; }},
            {false, "no carry", [](ModelPaletteJob& job) { job.carry = nullptr; }},
            {false, "carry off the alignment", [](ModelPaletteJob& job) { job.carry += 4; }},
            {false, "no branch_slots", [](ModelPaletteJob& job) { job.branch_slots = nullptr; }},
            {false, "branch_slots off the alignment", [](ModelPaletteJob& job) { job.branch_slots += 4; }},
            {false, "quads that no packet has", [](ModelPaletteJob& job) { job.displaced = all_quads + 1; }},
            {false, "no policy", [](ModelPaletteJob& job) { job.stores = static_cast<StorePolicy>(3); }},
            {true, "packed", [](ModelPaletteJob& job) { job.format = PaletteFormat::packed; }},
            {true, "a general skeleton", [](ModelPaletteJob& job) { job.hierarchy = &general; }},
            {false, "a general skeleton packed",
             [](ModelPaletteJob& job) { job.hierarchy = &general, job.format = PaletteFormat::packed; }}});
}

TEST_P(ModelPalette, AgreesWithDoublePrecisionMatricesOnEveryTarget) {
  constexpr double hundredth_of_a_millimetre = 1e-5;
  for (const Kernels& kernels : runnable_kernels()) {
    EXPECT_LT(largest_error(skeleton(), poses_, compute(kernels, widest_strip)), hundredth_of_a_millimetre)
        << kernels.target;
  }
}

TEST_P(ModelPalette, IsTheSameToTheBitForEveryStripWidth) {
  for (const Kernels& kernels : runnable_kernels()) {
    const CrowdResult widest = compute(kernels, widest_strip);
    for (const int width : all_widths) {
      const CrowdResult result = compute(kernels, width);
      EXPECT_EQ(result.hashes, widest.hashes) << kernels.target << " " << width;
      for (std::size_t i = 0; i < states_.size(); ++i) {
        EXPECT_TRUE(same_bits(result.palettes[i], widest.palettes[i])) << kernels.target << " " << width << " " << i;
      }
    }
  }
}

TEST_P(ModelPalette, IsTheSameToTheBitAmongTargetsThatFuseAndAmongThoseThatDoNot) {
  for (const bool fused : {false, true}) {
    const CrowdResult* first = nullptr;
    std::vector<CrowdResult> results;
    results.reserve(runnable_kernels().size());
    for (const Kernels& kernels : runnable_kernels()) {
      if (kernels.fused_multiply_add != fused) continue;
      results.push_back(compute(kernels, widest_strip));
      if (first == nullptr) first = &results.front();
      EXPECT_EQ(results.back().hashes, first->hashes) << kernels.target;
      for (std::size_t i = 0; i < states_.size(); ++i) {
        EXPECT_TRUE(same_bits(results.back().palettes[i], first->palettes[i])) << kernels.target << " " << i;
      }
    }
  }
}

TEST_P(ModelPalette, OfALevelIsAPrefixOfTheWholeAndWritesNothingElse) {
  for (const Kernels& kernels : runnable_kernels()) {
    for (const int width : {1, 8, 16}) {
      const CrowdResult whole = compute(kernels, width);
      EXPECT_TRUE(whole.guards_intact);
      for (int bones = 1; bones <= skeleton().bone_count(); ++bones) {
        const CrowdResult level = compute_palettes(kernels, program_, states_, width, bones);
        ASSERT_TRUE(level.guards_intact) << kernels.target << " " << width << " " << bones;
        for (std::size_t i = 0; i < states_.size(); ++i) {
          const auto& all = whole.palettes[i];
          const std::vector<PaletteMatrix> prefix(all.begin(),
                                                  all.begin() + static_cast<std::ptrdiff_t>(level.palettes[i].size()));
          ASSERT_TRUE(same_bits(level.palettes[i], prefix)) << kernels.target << " " << width << " " << bones;
        }
      }
    }
  }
}

TEST_P(ModelPalette, IsTheSameToTheBitHoweverItIsStored) {
  for (const Kernels& kernels : runnable_kernels()) {
    for (const int width : all_widths) {
      const CrowdResult expected = compute(kernels, width);
      for (const StorePolicy stores : {StorePolicy::plain, StorePolicy::streaming}) {
        const CrowdResult result =
            compute_palettes(kernels, program_, states_, width, skeleton().bone_count(), {.stores = stores});
        EXPECT_TRUE(result.guards_intact) << kernels.target << " " << width;
        for (std::size_t i = 0; i < states_.size(); ++i) {
          EXPECT_TRUE(same_bits(result.palettes[i], expected.palettes[i]))
              << kernels.target << " " << width << " " << i;
        }
      }
    }
  }
}

TEST_P(ModelPalette, HashIsTheSumOfTheHashesOfWhatWasWritten) {
  const CrowdResult result = compute(best_kernels(), widest_strip);
  for (std::size_t i = 0; i < states_.size(); ++i) {
    std::uint64_t expected = 0;
    for (std::size_t entry = 0; entry < result.palettes[i].size(); ++entry) {
      expected += palette_entry_hash(static_cast<std::uint32_t>(program_.skin_joint[entry]), result.palettes[i][entry]);
    }
    EXPECT_EQ(result.hashes[i], expected);
  }
}

TEST_P(ModelPalette, DoesNotDependOnTheNeighboursInTheStrip) {
  const CrowdResult together = compute(best_kernels(), widest_strip);
  const CrowdResult alone = compute_palettes(best_kernels(), program_, {states_[7]}, widest_strip, program_.bone_count);
  EXPECT_TRUE(same_bits(alone.palettes[0], together.palettes[7]));
}

INSTANTIATE_TEST_SUITE_P(Rigs, ModelPalette,
                         ::testing::Values(Rig{"rigid_branching", rigid_skeleton(branching_parents(62))},
                                           Rig{"rigid_chain", rigid_skeleton(chain_parents(21))},
                                           Rig{"rigid_single", rigid_skeleton({-1})},
                                           Rig{"rigid_two_roots", rigid_skeleton({-1, 0, -1, 2, 0})},
                                           Rig{"general_branching", general_skeleton(branching_parents(37))},
                                           Rig{"general_chain", general_skeleton(chain_parents(18))}),
                         [](const auto& rig) { return rig.param.name; });

TEST(RigidPalette, OfTheBindPoseIsTheIdentity) {
  const Skeleton skeleton = rigid_skeleton(branching_parents(62));
  const auto result = compute_palettes(best_kernels(), compile_hierarchy(skeleton),
                                       states(skeleton, {rest_pose(skeleton)}), widest_strip, skeleton.bone_count());
  for (const PaletteMatrix& entry : result.palettes.front()) {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) {
        EXPECT_NEAR(entry.rows[row][column], row == column ? 1.0F : 0.0F, 2e-6F);
      }
    }
  }
}

TEST(RigidPalette, IsTheSameToTheBitWhereFewQuadsAreDisplacedWhateverLiesInOthers) {
  for (const Skeleton& skeleton : {rigid_skeleton(branching_parents(62)), rigid_skeleton({-1, 0, -1, 2, 0})}) {
    const HierarchyProgram program = compile_hierarchy(skeleton);
    const std::vector<StatePose> poses = states(skeleton, random_poses(skeleton));
    for (const PaletteRequest& request : usual_requests) {
      const std::vector<StatePose> whole = displaced_in(request.displaced, poses);
      const std::vector<StatePose> partly = displaced_in(request.displaced, poses, not_there);
      for (const Kernels& kernels : runnable_kernels()) {
        const CrowdResult expected = compute_palettes(kernels, program, whole, widest_strip, skeleton.bone_count());
        const CrowdResult result =
            compute_palettes(kernels, program, partly, widest_strip, skeleton.bone_count(), request);
        EXPECT_TRUE(result.guards_intact) << kernels.target;
        for (std::size_t i = 0; i < poses.size(); ++i) {
          EXPECT_TRUE(same_bits(result.palettes[i], expected.palettes[i])) << kernels.target << " " << i;
        }
      }
    }
  }
}

TEST(Kernels, AreListedBestFirstAndEndWithTheScalarTarget) {
  EXPECT_STREQ(scalar_kernels().target, "SCALAR");
  EXPECT_FALSE(scalar_kernels().fused_multiply_add);
  EXPECT_EQ(&best_kernels(), &runnable_kernels().front());
  EXPECT_EQ(&scalar_kernels(), &runnable_kernels().back());
}

}  // namespace
}  // namespace throng::anim::model_palette_test
