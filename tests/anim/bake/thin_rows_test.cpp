#include "engine/anim/bake/thin_rows.h"

#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include "engine/anim/bake/character.h"
#include "tests/anim/asset/clip_fixtures.h"
#include "tests/anim/bake/definition_error.h"

namespace throng::anim::thin_rows_test {
namespace {

/// A rod of 1.8 m whose angle is a function of time, in 91 keys at 30 Hz.
template <typename Angle>
Model rod(Angle&& angle) {
  Model model = rod_model();
  BoneTracks tracks;
  for (int frame = 0; frame <= 90; ++frame) {
    const float seconds = static_cast<float>(frame) / 30.0F;
    tracks.rotation.times.push_back(seconds);
    tracks.rotation.values.push_back(glm::angleAxis(angle(seconds), glm::vec3(1.0F, 0.0F, 0.0F)));
  }
  model.clips.push_back(one_bone_clip(tracks, 3.0));
  return model;
}

float slow_then_fast(float seconds) {
  return seconds < 2.0F ? 0.01F * seconds : 0.02F + 0.5F * std::sin(20.0F * (seconds - 2.0F));
}

TEST(ThinnedClip, HasFewRowsWhereItIsSlowAndManyWhereItIsFast) {
  const Character character = bake_character(rod(slow_then_fast));
  const SampledStream& stream = *character.clips.front().sampled();
  const auto row_at = [&](double seconds) {
    return static_cast<int>((locate(stream, to_ticks(seconds)).from - stream.row(0)) /
                            static_cast<std::ptrdiff_t>(stream.row_stride));
  };
  EXPECT_LE(row_at(1.9), 4) << "60 steps of a slow turn";
  EXPECT_GE(row_at(2.99) - row_at(2.0), 25);
}

TEST(ThinnedClip, KeepsToItsBound) {
  const auto wave = [](float amplitude, float pace) {
    return [=](float seconds) { return amplitude * std::sin(pace * seconds); };
  };
  for (const auto& model : {rod(slow_then_fast), rod(wave(0.2F, 2.0F)), rod(wave(0.003F, 9.0F))}) {
    const Character character = bake_character(model);
    const BakedClip& clip = character.clips.front();
    ASSERT_NE(clip.sampled(), nullptr) << clip.note;
    EXPECT_LT(clip.sampled()->row_count, clip.sampled()->step_count);
    EXPECT_LE(clip.sampled_error, clip.error_bound);
    EXPECT_LE(error_by_definition(model, model.clips.front(), clip, 4000), clip.error_bound);
  }
}

TEST(ThinnedClip, KeepsASteadyTurnInRowsThatKernelsCanNormalise) {
  const Character character = bake_character(rod([](float seconds) { return 0.002F * seconds; }));
  const SampledStream& stream = *character.clips.front().sampled();
  EXPECT_EQ(stream.row_count, 4) << "90 steps, of which at most 32 lie between two rows";
  EXPECT_EQ(stream.steps()[0].steps(), most_steps_between_rows);
}

}  // namespace
}  // namespace throng::anim::thin_rows_test
