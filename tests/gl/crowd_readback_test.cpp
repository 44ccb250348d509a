#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/gl/gl_test.h"
#include "tests/gl/staged_crowd.h"

namespace throng::app::test::crowd_readback_test {
namespace {

constexpr std::array<std::uint32_t, 3> watched{0, 16, 39};  // a walker, the first agent that stands, the last agent

// Metres, for an exact stream; 8e-6 were measured. Floats and 16-bit weights leave 1.5e-6. A fade between clips blends
// rotations that are unit only to 1e-6, which adds up along a chain of bones. The shader's clock counts whole
// microseconds, and a walking foot moves 3e-6 in one.
constexpr double exact_tolerance = 2e-5;

// Packing adds this many metres: a rotation has 16 bits, seen at the length of a limb, and a joint's position counts in
// units of 31 micrometres.
constexpr double packing_tolerance = 5e-5;

/// Sets up a crowd in which the watched agents differ in interval and bone level, and change level as the camera moves
/// back.
Tuning tuning_of(LodRule lod, anim::StreamKind stream, PaletteFormat palette = PaletteFormat::matrices) {
  Tuning tuning;
  tuning.system.palettes = palette;
  tuning.agents = 40;
  tuning.placed_feet = tuning.wardrobe = false;  // the reference has neither
  tuning.system.pus = 2;
  tuning.lod.rule = lod;
  tuning.lod.bone_lod = lod != LodRule::off;
  tuning.system.stream = stream;
  tuning.lod.full_rate_distance = 6.0F;
  tuning.lod.interval_growth = 6.0F;
  tuning.lod.level_distances = {20.0F, 23.0F, 60.0F};  // the camera is about 20 m away
  return tuning;
}

/// A sampled stream is off by at most the error that its baking measured, at the largest scale; a blend of two is off
/// by no more.
double tolerance_of(const Stage& stage) {
  const double format = stage.tuning().system.palettes == PaletteFormat::packed ? packing_tolerance : 0.0;
  if (stage.tuning().system.stream == anim::StreamKind::keyframe) return exact_tolerance + format;
  const auto& clips = stage.characters().front().character->clips;
  const double worst = std::ranges::max_element(clips, {}, &anim::BakedClip::sampled_error)->sampled_error;
  return exact_tolerance + format + worst * static_cast<double>(std::ranges::max(stage.crowd().scales()));
}

class StagedCrowdTest : public render::test::SoftwareGlTest {
 protected:
  void TearDown() override {
    crowd_.reset();
    SoftwareGlTest::TearDown();
  }

  void stage(const Tuning& tuning) {
    crowd_ = std::make_unique<StagedCrowd>(context(), tuning);
    tolerance_ = tolerance_of(crowd_->stage());
  }
  /// Runs until every watched agent is between two slots.
  void pass_until_all_blend() {
    const auto blends = [this](std::uint32_t agent) { return crowd().blends(agent); };
    int frames = 0;
    do {
      crowd().pass_frame();
      ASSERT_LT(++frames, 60);
    } while (!std::ranges::all_of(watched, blends));
  }
  StagedCrowd& crowd() { return *crowd_; }
  double tolerance() const { return tolerance_; }

 private:
  std::unique_ptr<StagedCrowd> crowd_;
  double tolerance_ = 0.0;
};

struct Mode {
  const char* name;
  LodRule lod;
  anim::StreamKind stream;
  PaletteFormat palette = PaletteFormat::matrices;
};

class CrowdReadBack : public StagedCrowdTest, public testing::WithParamInterface<Mode> {
 protected:
  void SetUp() override {
    StagedCrowdTest::SetUp();
    stage(tuning_of(GetParam().lod, GetParam().stream, GetParam().palette));
  }
  bool skips() const { return GetParam().lod != LodRule::off; }

  void expect_where_the_reference_is(std::uint32_t agent) {
    EXPECT_LT(crowd().largest_error(agent), tolerance())
        << "agent " << agent << " at frame " << crowd().stage().posed().frame();
    const ShownPose& pose = crowd().stage().posed().shown().pose(agent);
    levels_.insert(pose.level());
    blended_ = blended_ || crowd().blends(agent);
    blended_levels_ = blended_levels_ || (crowd().blends(agent) && pose.from_level != pose.to_level);
  }

  // These say what was compared:
  std::set<int> levels_;
  bool blended_ = false;         // an agent was between two slots
  bool blended_levels_ = false;  // and the slots had different bone levels
};

// Mesh LODs are triangles over the same vertices, so all vertices of all LODs are compared.
TEST_P(CrowdReadBack, HasFirstSeventeenthAndLastAgentWhereTheReferenceHasThem) {
  for (int frame = 0; frame < 48; ++frame) {
    crowd().pass_frame();
    crowd().draw_camera_back(0.15F);
    for (const std::uint32_t agent : watched) expect_where_the_reference_is(agent);
  }
  EXPECT_EQ(blended_, skips());
  EXPECT_EQ(blended_levels_, skips());
  EXPECT_EQ(levels_, skips() ? std::set({0, 1, 2}) : std::set({0}));
}

TEST_P(CrowdReadBack, HasThemThereWhileTheyFadeFromClipToClip) {
  constexpr int longest_wait = 15 * 60;  // frames, for an agent that rests
  constexpr int enough = 8;
  for (const std::uint32_t agent : {16U, 39U}) {
    int compared = 0;
    for (int frame = 0; frame < longest_wait && compared < enough; ++frame) {
      crowd().pass_frame();
      if (!crowd().reference().fades(agent)) continue;
      expect_where_the_reference_is(agent);
      ++compared;
    }
    EXPECT_EQ(compared, enough) << agent;
  }
  EXPECT_EQ(blended_, skips());
}

INSTANTIATE_TEST_SUITE_P(
    Of, CrowdReadBack,
    testing::Values(
        Mode{"SampledStreamsUpdatedEachFrame", LodRule::off, anim::StreamKind::sampled},
        Mode{"SampledStreamsSkippedSmoothly", LodRule::distance, anim::StreamKind::sampled},
        Mode{"KeyframeStreamsUpdatedEachFrame", LodRule::off, anim::StreamKind::keyframe},
        Mode{"KeyframeStreamsSkippedSmoothly", LodRule::distance, anim::StreamKind::keyframe},
        Mode{"PackedPalettesUpdatedEachFrame", LodRule::off, anim::StreamKind::keyframe, PaletteFormat::packed},
        Mode{"PackedPalettesSkippedSmoothly", LodRule::distance, anim::StreamKind::keyframe, PaletteFormat::packed}),
    [](const auto& test) { return std::string(test.param.name); });

class PackedCrowd : public StagedCrowdTest {};

// app/commands/command_line/README.md states these figures (--palette).
TEST_F(PackedCrowd, IsOffByLessThanATwentiethOfAMillimetreAndAFortiethOfAPixelOfTheNearestAgent) {
  stage(tuning_of(LodRule::off, anim::StreamKind::keyframe, PaletteFormat::packed));
  double metres = 0.0;
  for (int frame = 0; frame < 12; ++frame) {
    crowd().pass_frame();
    for (const std::uint32_t agent : watched) metres = std::max(metres, crowd().largest_error(agent));
  }
  constexpr double pixels_a_radian = 720.0 / 2.0 / 0.4663;  // in a picture of 720 lines, at 50 degrees
  constexpr double nearest = 2.0;                           // metres: a camera comes no nearer to a person
  const double pixels = metres * pixels_a_radian / nearest;
  RecordProperty("error_micrometres", static_cast<int>(metres * 1e6));
  RecordProperty("error_thousandths_of_a_pixel", static_cast<int>(pixels * 1e3));
  EXPECT_LT(metres, 5e-5);
  EXPECT_LT(pixels, 0.025);
  EXPECT_GT(metres, 1e-6) << "nothing was packed";
}

TEST_F(PackedCrowd, GoesTheShortestWayBetweenTwoPoses) {
  Tuning tuning = tuning_of(LodRule::distance, anim::StreamKind::keyframe, PaletteFormat::packed);
  tuning.lod.bone_lod = false;
  stage(tuning);
  ASSERT_NO_FATAL_FAILURE(pass_until_all_blend());
  for (const std::uint32_t agent : watched) {
    crowd().negate_rotations(agent);
    EXPECT_LT(crowd().largest_error(agent), tolerance()) << agent;
  }
}

TEST_F(PackedCrowd, TakesUpAnotherFormatWhileItRuns) {
  stage(tuning_of(LodRule::distance, anim::StreamKind::keyframe));
  for (int frame = 0; frame < 30; ++frame) {
    const PaletteFormat palette = frame / 10 == 1 ? PaletteFormat::packed : PaletteFormat::matrices;
    if (frame % 10 == 0) crowd().retune(tuning_of(LodRule::distance, anim::StreamKind::keyframe, palette));
    crowd().pass_frame();
    for (const std::uint32_t agent : watched) {
      EXPECT_LT(crowd().largest_error(agent), tolerance() + packing_tolerance) << agent << " at frame " << frame;
    }
  }
}

/// A crowd whose stage measures every agent.
class MeasuredCrowd : public StagedCrowdTest {
 protected:
  void SetUp() override {
    StagedCrowdTest::SetUp();
    Tuning tuning = tuning_of(LodRule::distance, anim::StreamKind::keyframe);
    tuning.error_sample = ErrorSampling::all;
    stage(tuning);
  }
};

TEST_F(MeasuredCrowd, IsOffByWhatTheWholeSurfaceReadBackFromTheDeviceIs) {
  constexpr double seen = 0.85;    // the points see this share of the worst vertex's error
  constexpr double least = 0.005;  // pixels, in a picture of 64 x 36
  std::set<int> levels;
  int compared = 0;
  for (int frame = 0; frame < 48; ++frame) {
    crowd().pass_frame();
    crowd().draw_camera_back(0.15F);
    if (frame < 16) continue;
    for (const std::uint32_t agent : watched) {
      const double measured = static_cast<double>(crowd().stage().posed().error_meter().error_of(agent));
      const double on_device = crowd().largest_error_on_screen(agent);
      EXPECT_LT(measured, 1.02 * on_device + least)
          << "agent " << agent << " at frame " << crowd().stage().posed().frame();
      EXPECT_GT(measured, seen * on_device - least)
          << "agent " << agent << " at frame " << crowd().stage().posed().frame();
      if (on_device < 4 * least) continue;
      levels.insert(crowd().stage().posed().shown().pose(agent).level());
      ++compared;
    }
  }
  EXPECT_GT(compared, 40);
  EXPECT_GE(levels.size(), 2U);
}

/// A crowd with exact streams at a moment when every watched agent is shown between two slots, so that little hides a
/// fault.
class BlendedCrowd : public StagedCrowdTest {
 protected:
  void SetUp() override {
    StagedCrowdTest::SetUp();
    stage(tuning_of(LodRule::distance, anim::StreamKind::keyframe));
    ASSERT_NO_FATAL_FAILURE(pass_until_all_blend());
    for (const std::uint32_t agent : watched) ASSERT_LT(crowd().largest_error(agent), tolerance()) << agent;
  }
};

using Palette = std::vector<anim::PaletteMatrix>;

Palette as_meant(const std::vector<glm::dmat4>& matrices) {
  Palette palette;
  for (const glm::dmat4& matrix : matrices) palette.push_back(rows_of(matrix));
  return palette;
}

Palette off_by_one_bone(const std::vector<glm::dmat4>& matrices) {
  Palette palette = as_meant(matrices);
  std::rotate(palette.begin(), palette.begin() + 1, palette.end());
  return palette;
}

// The fault is columns in the place of rows.
Palette transposed(const std::vector<glm::dmat4>& matrices) {
  Palette palette;
  for (const glm::dmat4& matrix : matrices) {
    anim::PaletteMatrix& entry = palette.emplace_back();
    for (int i = 0; i < 12; ++i) entry.rows[i / 4][i % 4] = static_cast<float>(matrix[i / 3][i % 3]);
  }
  return palette;
}

void take_slots_of_neighbour(StagedCrowd& crowd, std::uint32_t agent) {
  const render::InstanceRecord& neighbour = crowd.record(agent == 0 ? 1 : agent - 1);
  crowd.record(agent).palette_from = neighbour.palette_from;
  crowd.record(agent).palette_to = neighbour.palette_to;
}

void turn_by_a_degree(StagedCrowd& crowd, std::uint32_t agent) {
  render::InstanceRecord& record = crowd.record(agent);
  const float angle = std::atan2(record.heading_sine, record.heading_cosine) + 0.01745F;
  record.heading_cosine = std::cos(angle);
  record.heading_sine = std::sin(angle);
}

void start_blend_a_frame_late(StagedCrowd& crowd, std::uint32_t agent) {
  constexpr std::uint32_t frame_microseconds = 1'000'000 / 60;
  crowd.record(agent).blend_start += frame_microseconds;
}

struct Fault {
  const char* name;
  void (*plant)(StagedCrowd& crowd, std::uint32_t agent);
};

class PlantedFault : public BlendedCrowd, public testing::WithParamInterface<Fault> {};

TEST_P(PlantedFault, IsReportedOfFirstSeventeenthAndLastAgent) {
  for (const std::uint32_t agent : watched) {
    GetParam().plant(crowd(), agent);
    EXPECT_GT(crowd().largest_error(agent), tolerance()) << agent;
  }
}

INSTANTIATE_TEST_SUITE_P(Where, PlantedFault,
                         testing::Values(Fault{"PaletteIsOffByOneBone",
                                               [](StagedCrowd& crowd, std::uint32_t agent) {
                                                 crowd.rewrite_palettes(agent, off_by_one_bone);
                                               }},
                                         Fault{"MatricesAreTransposed",
                                               [](StagedCrowd& crowd, std::uint32_t agent) {
                                                 crowd.rewrite_palettes(agent, transposed);
                                               }},
                                         Fault{"InstanceIsOffByOneSlot", take_slots_of_neighbour},
                                         Fault{"HeadingIsOffByADegree", turn_by_a_degree},
                                         Fault{"BlendStartsAFrameLate", start_blend_a_frame_late}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_F(BlendedCrowd, IsReportedToBeOffByAsMuchAsOneBoneIs) {
  constexpr double distance = 0.05;
  const auto& bones = crowd().stage().characters().front().model.skeleton.bones;
  // At every bone level some vertices follow a shin alone.
  const auto found = std::ranges::find(bones, "shin.L", &anim::Bone::name);
  ASSERT_NE(found, bones.end());
  const auto shin = static_cast<std::size_t>(found - bones.begin());
  for (const std::uint32_t agent : watched) {
    crowd().rewrite_palettes(agent, [shin](const std::vector<glm::dmat4>& matrices) {
      Palette palette = as_meant(matrices);
      palette[shin].rows[1][3] += static_cast<float>(distance);
      return palette;
    });
    EXPECT_NEAR(crowd().largest_error(agent), distance * crowd().reference().scale(agent), tolerance()) << agent;
  }
}

// Writing the slots anew without a change is no fault.
TEST_F(BlendedCrowd, IsReportedAsRightWithPalettesWrittenAnewAsMeant) {
  for (const std::uint32_t agent : watched) {
    crowd().rewrite_palettes(agent, as_meant);
    EXPECT_LT(crowd().largest_error(agent), tolerance()) << agent;
  }
}

}  // namespace
}  // namespace throng::app::test::crowd_readback_test
