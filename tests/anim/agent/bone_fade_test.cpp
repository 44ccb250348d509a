// From one bone level to another without a pop: what an update shows of bones that come or go.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/asset/synthetic_model.h"

namespace throng::anim::bone_fade_test {
namespace {

constexpr std::uint8_t coarser = 1;

const Model& model() {
  static const Model made = synthetic_model(62, 1);
  return made;
}

using Palette = std::vector<PaletteMatrix>;

struct Fade {
  std::uint8_t level = 0, fade_level = 0, halves = 0;
};

/// One agent at the same moment, posed in any way.
Palette pose(const Fade& fade, const SystemOptions& options) {
  auto system = AnimationSystem::create(std::make_shared<const Character>(bake_character(model())), options);
  EXPECT_TRUE(system);
  (*system)->set_agent_count(1);
  (*system)->agent(0).play({.clip = 0, .start = to_ticks(0.3)});
  Palette palette(64);
  const PoseRequest update{.agent = {0},
                           .level = fade.level,
                           .palette = PaletteDestination(palette.data()).memory(),
                           .fade_level = fade.fade_level,
                           .fade_halves = fade.halves};
  (*system)->update({&update, 1});
  return palette;
}

float difference(const PaletteMatrix& a, const PaletteMatrix& b) {
  const auto* left = reinterpret_cast<const float*>(&a);
  const auto* right = reinterpret_cast<const float*>(&b);
  float most = 0.0F;
  for (std::size_t i = 0; i < sizeof(PaletteMatrix) / sizeof(float); ++i) {
    most = std::max(most, std::abs(left[i] - right[i]));
  }
  return most;
}

/// Metres that points a tenth of a metre above each joint go at most; `read_to`: the entry that shows each in `to`.
float largest_step(const Palette& from, const Palette& to, const std::vector<int>& read_to) {
  float most = 0.0F;
  for (const BoneLodRow& row : measure_bone_lod(model()).rows) {
    const auto entry = static_cast<std::size_t>(row.bone);
    const glm::vec3 place(model().skeleton.references[entry].origin + glm::dvec3(0.0, 0.1, 0.0));
    const auto at = [&](const PaletteMatrix& matrix) {
      const auto* row_major = reinterpret_cast<const float*>(&matrix);
      glm::vec3 moved(0.0F);
      for (int i = 0; i < 3; ++i) {
        const float* line = row_major + static_cast<std::ptrdiff_t>(4) * i;
        moved[i] = line[0] * place.x + line[1] * place.y + line[2] * place.z + line[3];
      }
      return moved;
    };
    most = std::max(most, glm::distance(at(from[entry]), at(to[static_cast<std::size_t>(read_to[entry])])));
  }
  return most;
}

std::vector<SystemOptions> both_schedules() {
  SystemOptions levels;
  levels.schedule = Schedule::levels;
  return {SystemOptions{}, levels};
}

TEST(BoneFade, IsOverWhereTheCoarserLevelsMeshShowsTheSame) {
  const std::vector<int> kept = kept_entries(model().skeleton, model().skeleton.level_bone_counts[coarser]);
  for (const SystemOptions& options : both_schedules()) {
    const Palette faded = pose({.level = 0, .fade_level = coarser, .halves = 2}, options);
    const Palette coarse = pose({.level = coarser, .fade_level = coarser}, options);
    for (std::size_t entry = 0; entry < kept.size(); ++entry) {
      EXPECT_LT(difference(faded[entry], coarse[static_cast<std::size_t>(kept[entry])]), 1e-5F) << entry;
    }
  }
}

TEST(BoneFade, LeavesTheBonesOfTheCoarserLevelAsTheyWereToTheBit) {
  const auto count = static_cast<std::size_t>(model().skeleton.level_bone_counts[coarser]);
  for (const SystemOptions& options : both_schedules()) {
    const Palette full = pose({}, options);
    const Palette half = pose({.level = 0, .fade_level = coarser, .halves = 1}, options);
    for (std::size_t entry = 0; entry < count; ++entry) EXPECT_EQ(difference(full[entry], half[entry]), 0.0F) << entry;
  }
}

TEST(BoneFade, TakesTwoStepsOfAboutHalfThePopEach) {
  std::vector<int> same(64);
  for (std::size_t i = 0; i < same.size(); ++i) same[i] = static_cast<int>(i);
  const std::vector<int> kept = kept_entries(model().skeleton, model().skeleton.level_bone_counts[coarser]);
  const Palette full = pose({}, {});
  const Palette half = pose({.level = 0, .fade_level = coarser, .halves = 1}, {});
  const Palette faded = pose({.level = 0, .fade_level = coarser, .halves = 2}, {});
  const Palette coarse = pose({.level = coarser, .fade_level = coarser}, {});
  const float pop = largest_step(full, coarse, kept);
  ASSERT_GT(pop, 0.01F) << "the level has something to lose";
  EXPECT_LT(largest_step(full, half, same), 0.65F * pop);
  EXPECT_LT(largest_step(half, faded, same), 0.65F * pop);
  EXPECT_LT(largest_step(faded, coarse, kept), 1e-4F) << "the mesh changes here";
  RecordProperty("pop_mm", static_cast<int>(1000 * pop));
  RecordProperty("largest_step_mm", static_cast<int>(1000 * largest_step(full, half, same)));
}

}  // namespace
}  // namespace throng::anim::bone_fade_test
