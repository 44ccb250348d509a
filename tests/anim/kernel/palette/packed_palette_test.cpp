#include "engine/anim/kernel/palette/packed_palette.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "engine/anim/kernel/palette/palette_hash.h"
#include "tests/anim/kernel/palette/palette_rig.h"

namespace throng::anim::packed_palette_test {
namespace {

using namespace kernel_rig;

constexpr int all_widths[] = {1, 2, 4, 8, 16};

TEST(PaletteStride, HoldsAllEntriesInAnOddNumberOfLines) {
  for (const PaletteFormat format : {PaletteFormat::matrices, PaletteFormat::packed}) {
    for (std::size_t entries = 1; entries <= 1024; ++entries) {
      const std::size_t stride = palette_stride(entries, format), needed = entries * palette_entry_bytes(format);
      EXPECT_EQ(stride % 128, 64U) << entries;
      EXPECT_GE(stride, needed);
      EXPECT_LT(stride, needed + 128);
    }
  }
}

struct Rig {
  std::string name;
  Skeleton skeleton;
};

std::ostream& operator<<(std::ostream& out, const Rig& rig) { return out << rig.name; }

class PackedPalette : public ::testing::TestWithParam<Rig> {
 protected:
  PackedPalette() {
    for (unsigned i = 0; i < 19; ++i) {  // one strip and a bit
      poses_.push_back(random_pose(skeleton(), i));
      states_.emplace_back(skeleton(), poses_.back());
    }
  }
  const Skeleton& skeleton() const { return GetParam().skeleton; }
  PackedCrowdResult compute(const Kernels& kernels, int width, StorePolicy stores = StorePolicy::prefetched) const {
    return compute_packed_palettes(kernels, program_, states_, width, skeleton().bone_count(), {.stores = stores});
  }
  std::vector<PaletteMatrix> unpacked(const std::vector<PackedPaletteEntry>& palette) const {
    const std::vector<PackingFrame> frames = packing_frames(skeleton());
    std::vector<PaletteMatrix> matrices;
    for (std::size_t i = 0; i < palette.size(); ++i) matrices.push_back(unpack(palette[i], frames[i]));
    return matrices;
  }

  const HierarchyProgram program_ = compile_hierarchy(GetParam().skeleton);
  std::vector<LocalPose> poses_;
  std::vector<StatePose> states_;
};

// Half a unit of each component of a rotation turns by at most 5.3e-5 rad, seen a metre from the joint; half a step of
// each coordinate of a joint is at most 26 micrometres in these boxes.
TEST_P(PackedPalette, AgreesWithDoublePrecisionMatricesToATenthOfAMillimetreAMetreFromTheJoint) {
  for (const Kernels& kernels : runnable_kernels()) {
    const PackedCrowdResult result = compute(kernels, widest_strip);
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      const double error =
          largest_error(skeleton(), reference_palette(skeleton(), poses_[i]), unpacked(result.palettes[i]));
      EXPECT_LT(error, 1e-4) << kernels.target << " " << i;
    }
  }
}

TEST_P(PackedPalette, IsTheSameToTheBitForEveryStripWidthAndStore) {
  for (const Kernels& kernels : runnable_kernels()) {
    const PackedCrowdResult widest = compute(kernels, widest_strip);
    for (const int width : all_widths) {
      for (const StorePolicy stores : {StorePolicy::plain, StorePolicy::prefetched, StorePolicy::streaming}) {
        const PackedCrowdResult result = compute(kernels, width, stores);
        EXPECT_EQ(result.hashes, widest.hashes) << kernels.target << " " << width;
        EXPECT_TRUE(result.guards_intact) << kernels.target << " " << width;
        for (std::size_t i = 0; i < states_.size(); ++i) {
          EXPECT_TRUE(same_bits(result.palettes[i], widest.palettes[i])) << kernels.target << " " << width << " " << i;
        }
      }
    }
  }
}

TEST_P(PackedPalette, IsTheSameToTheBitAmongTargetsThatFuse) {
  const PackedCrowdResult best = compute(best_kernels(), widest_strip);
  for (const Kernels& kernels : runnable_kernels()) {
    if (kernels.fused_multiply_add != best_kernels().fused_multiply_add) continue;
    EXPECT_EQ(compute(kernels, widest_strip).hashes, best.hashes) << kernels.target;
  }
}

TEST_P(PackedPalette, OfALevelIsAPrefixOfTheWholeAndWritesNothingElse) {
  for (const Kernels& kernels : runnable_kernels()) {
    const PackedCrowdResult whole = compute(kernels, widest_strip);
    for (int bones = 1; bones <= skeleton().bone_count(); ++bones) {
      const PackedCrowdResult level = compute_packed_palettes(kernels, program_, states_, widest_strip, bones);
      ASSERT_TRUE(level.guards_intact) << kernels.target << " " << bones;
      for (std::size_t i = 0; i < states_.size(); ++i) {
        const auto& all = whole.palettes[i];
        ASSERT_TRUE(same_bits(level.palettes[i], {all.begin(), all.begin() + bones})) << kernels.target << " " << bones;
      }
    }
  }
}

TEST_P(PackedPalette, IsTheSameToTheBitWhereFewQuadsAreDisplacedWhateverLiesInOthers) {
  for (const PaletteRequest& request : usual_requests) {
    const std::vector<StatePose> whole = displaced_in(request.displaced, states_);
    const std::vector<StatePose> partly = displaced_in(request.displaced, states_, not_there);
    for (const Kernels& kernels : runnable_kernels()) {
      const auto expected = compute_packed_palettes(kernels, program_, whole, widest_strip, skeleton().bone_count());
      const auto result =
          compute_packed_palettes(kernels, program_, partly, widest_strip, skeleton().bone_count(), request);
      EXPECT_TRUE(result.guards_intact) << kernels.target;
      for (std::size_t i = 0; i < states_.size(); ++i) {
        EXPECT_TRUE(same_bits(result.palettes[i], expected.palettes[i])) << kernels.target << " " << i;
      }
    }
  }
}

TEST_P(PackedPalette, HashIsTheSumOfTheHashesOfWhatWasWritten) {
  const PackedCrowdResult result = compute(best_kernels(), widest_strip);
  for (std::size_t i = 0; i < states_.size(); ++i) {
    std::uint64_t expected = 0;
    for (std::size_t entry = 0; entry < result.palettes[i].size(); ++entry) {
      expected += palette_entry_hash(static_cast<std::uint32_t>(program_.skin_joint[entry]), result.palettes[i][entry]);
    }
    EXPECT_EQ(result.hashes[i], expected);
  }
}

TEST_P(PackedPalette, DoesNotDependOnTheNeighboursInTheStrip) {
  const PackedCrowdResult together = compute(best_kernels(), widest_strip);
  const PackedCrowdResult alone =
      compute_packed_palettes(best_kernels(), program_, {states_[7]}, widest_strip, program_.bone_count);
  EXPECT_TRUE(same_bits(alone.palettes[0], together.palettes[7]));
}

INSTANTIATE_TEST_SUITE_P(Rigs, PackedPalette,
                         ::testing::Values(Rig{"branching", rigid_skeleton(branching_parents(62))},
                                           Rig{"chain", rigid_skeleton(chain_parents(21))},
                                           Rig{"two_roots", rigid_skeleton({-1, 0, -1, 2, 0})}),
                         [](const auto& rig) { return rig.param.name; });

constexpr PackingFrame at_origin{{0.0F, 0.0F, 0.0F}, 0.5F};

TEST(UnpackedPalette, HoldsJointsToBothEndsOfTheirBits) {
  // x = -2^20, y = 2^20 - 1, z = -1, no turn
  const PackedPaletteEntry entry{{0U, 32700U << 16U, 0x100000U | (0x7FFU << 21U), 0x1FFU | (~0U << 10U)}};
  const PaletteMatrix matrix = unpack(entry, at_origin);
  EXPECT_EQ(matrix.rows[0][3], -524288.0F);
  EXPECT_EQ(matrix.rows[1][3], 524287.5F);
  EXPECT_EQ(matrix.rows[2][3], -0.5F);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(matrix.rows[i][i], 1.0F);
}

TEST(UnpackedPalette, TurnsAboutThePivot) {
  // half a turn about y
  const PackedPaletteEntry entry{{32700U << 16U, 0U, 0U, 0U}};
  const PaletteMatrix matrix = unpack(entry, {{1.0F, 2.0F, 3.0F}, 0.5F});
  EXPECT_EQ(matrix.rows[0][0], -1.0F);
  EXPECT_EQ(matrix.rows[0][3], 1.0F);  // the pivot itself comes to lie at the joint, which is the origin
  EXPECT_EQ(matrix.rows[1][3], -2.0F);
  EXPECT_EQ(matrix.rows[2][3], 3.0F);
}

TEST(UnpackedPalette, BetweenTwoGoesTheShortestWay) {
  constexpr auto quarter = static_cast<std::uint16_t>(static_cast<std::int16_t>(-23122));  // -sin(45 degrees)
  const PackedPaletteEntry rest{{0U, 32700U << 16U, 0U, 0U}};
  const PackedPaletteEntry turned{
      {0U, quarter | (std::uint32_t{quarter} << 16U), 4U, 0U}};  // 90 degrees about z, as -q
  const PaletteMatrix half = unpack_between(rest, turned, at_origin, 0.5F);
  EXPECT_NEAR(half.rows[1][0], std::sqrt(0.5F), 1e-5F);
  EXPECT_NEAR(half.rows[0][0], std::sqrt(0.5F), 1e-5F);
  EXPECT_EQ(half.rows[0][3], 1.0F);
}

TEST(PackingFrames, AreThereForRigidSkeletonsThatHaveSomeExtent) {
  const Skeleton rigid = rigid_skeleton(branching_parents(20));
  EXPECT_EQ(packing_frames(rigid).size(), rigid.palette.size());
  EXPECT_TRUE(compile_hierarchy(rigid).packs());

  const Skeleton general = general_skeleton(branching_parents(20));
  EXPECT_TRUE(packing_frames(general).empty());
  EXPECT_FALSE(compile_hierarchy(general).packs());

  Skeleton point = rigid_skeleton({-1});
  point.references.front().origin = {};
  EXPECT_TRUE(packing_frames(point).empty());
  EXPECT_FALSE(compile_hierarchy(point).packs());
}

TEST(PackingFrames, GiveAPersonABoxOf32MetresToEachSide) {
  Skeleton person = rigid_skeleton(chain_parents(2));
  person.references[0].origin = {0.0, 1.0, 0.0};
  person.references[1].origin = {0.0, 1.7, 0.0};
  EXPECT_EQ(packing_frames(person)[1].step, std::ldexp(1.0F, -15));
  EXPECT_EQ(packing_frames(person)[1].pivot[1], 1.7F);
}

TEST(PackingFrames, PackWhatIsOutsideTheBoxAtItsSide) {
  const Skeleton skeleton = rigid_skeleton({-1});
  LocalPose pose = rest_pose(skeleton);
  pose.front().position = {1e6, -1e6, 0.0};
  const HierarchyProgram program = compile_hierarchy(skeleton);
  for (const Kernels& kernels : runnable_kernels()) {
    const PackedCrowdResult result = compute_packed_palettes(kernels, program, {StatePose(skeleton, pose)}, 1, 1);
    PackingFrame frame = packing_frames(skeleton).front();
    std::fill(std::begin(frame.pivot), std::end(frame.pivot), 0.0F);
    const PaletteMatrix matrix = unpack(result.palettes.front().front(), frame);
    EXPECT_EQ(matrix.rows[0][3], packed_joint_limit * frame.step) << kernels.target;
    EXPECT_EQ(matrix.rows[1][3], -packed_joint_limit * frame.step) << kernels.target;
  }
}

}  // namespace
}  // namespace throng::anim::packed_palette_test
