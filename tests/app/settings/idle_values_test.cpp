// A value that is said to have no effect has none on anything that is chosen, posed, drawn or reported; every other
// value has one. All values of the table are tried under each rule, and under the values that make others idle.

#include "app/settings/idle_values.h"

#include <array>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "throng/heap_pages.h"

#include "app/character/built_in.h"
#include "app/settings/choices.h"
#include "app/settings/tuning_values.h"
#include "app/show/camera/fly_camera.h"
#include "app/show/picture.h"
#include "app/show/report/tuning_sweep.h"
#include "app/show/stage/stage.h"

namespace throng::app::idle_values_test {
namespace {

constexpr Ticks frame = ticks_per_second / 60;
constexpr int frames = 20, agents = 200;

/// Another value than the default one, by which the crowd below shows a difference if it can.
const std::map<std::string_view, std::string> other_values{
    {"scene", "grid"},
    {"agents", "300"},
    {"seed", "2"},
    {"variety", "off"},
    {"tint", "0.3"},
    {"size_variety", "0.25"},
    {"mesh_error_px", "0.05"},
    {"triangle_budget", "1000"},
    {"paused", "on"},
    {"time_scale", "2"},
    {"placed_feet", "off"},
    {"lod", "off"},
    {"full_rate_distance", "2"},
    {"interval_growth", "3"},
    {"largest_interval", "1"},
    {"error_sample", "all"},
    {"error_px", "0.1"},
    {"budget_ms", "0.02"},
    {"forced_interval", "5"},
    {"forced_bone_level", "2"},
    {"force_selected_only", "on"},
    {"smooth", "off"},
    {"bone_lod", "off"},
    {"bone_level_distance_1", "4"},
    {"bone_level_distance_2", "16"},
    {"bone_level_distance_3", "45"},
    {"mesh_lod", "2"},
    {"pus", "1"},
    {"local_store_kib", "256"},
    {"tile", "2"},
    {"schedule", "levels"},
    {"double_buffer", "off"},
    {"stream", "keyframe"},
    {"palette", "packed"},
    {"clothes", "pattern"},
    {"wardrobe", "off"},
    {"weather", "rain"},
    {"sun_elevation", "20"},
    {"sun_azimuth", "10"},
    {"clouds", "0.9"},
    {"exposure", "1"},
    {"shadows", "off"},
    {"crowd_shade", "off"},
    {"debug_view", "interval"},
    {"plain_bodies", "on"},
    {"top_speed", "0.5"},
    {"top_density", "1"},
    {"top_presence", "5"},
    {"density_cut_off", "2"},
    {"trail_seconds", "10"},
    {"bones_as_lines", "on"},
    {"scenery", "off"},
    {"cost_tile_ns", "90000"},
    {"cost_tile_packet_ns", "90000"},
    {"cost_agent_ns", "90000"},
    {"cost_player_packet_ns", "90000"},
    {"cost_blender_packet_ns", "90000"},
    {"cost_post_process_ns", "90000"},
    {"cost_least_task_ns", "900000000"},
};

/// A window or the overlay alone takes these; no crowd sees them.
const std::set<std::string_view> unseen{"ids",        "picture_size", "holds_rate",
                                        "frame_rate", "frame_limit",  "vertical_sync"};

std::vector<CharacterSource> mannequin() {
  static const CharacterSource loaded = *load_built_in("", {.wardrobe = true});
  return {loaded};
}

/// A crowd, and a hash over all that a person sees of it: who is chosen and how, every pose, all that is drawn, and the
/// figures that no clock measures.
class Seen {
 public:
  Seen(const Tuning& tuning, std::optional<std::uint32_t> selected) {
    auto made = Stage::create(mannequin(), tuning, pages_);
    if (!made) {
      refusal_ = made.error().message;
      return;
    }
    stage_ = std::move(*made);
    for (std::size_t i = 0; i < stage_->characters().size(); ++i) {
      stage_->posed().mesh_lods().set(i, {{0.0F, 0.0F}, {0.004F, 0.004F}, {0.02F, 0.02F}, {0.06F, 0.06F}},
                                      {4000, 2000, 1000, 500});
    }
    stage_->select(selected);
    for (int i = 0; i < frames; ++i) pass_frame(tuning);
  }

  std::uint64_t hash() const { return hash_; }
  const std::string& refusal() const { return refusal_; }

 private:
  // As the window does it.
  void pass_frame(const Tuning& tuning) {
    const bool stands = tuning.paused || tuning.taken_away.animation;
    const Ticks step = stands ? Ticks{} : to_ticks(to_seconds(frame) * static_cast<double>(tuning.time_scale));
    stage_->move(step);
    stage_->pose(camera_, 640, 360, step, stage_->posed().frame());
    add_choices();
    add_figures();
    if (!tuning.taken_away.drawing) add_picture(tuning);
  }

  template <typename Value>
  void add(const Value& value) {
    std::uint64_t bits = 0;
    static_assert(sizeof(value) <= sizeof(bits));
    std::memcpy(&bits, &value, sizeof(value));
    hash_ = (hash_ ^ bits) * 0x100000001b3U + (hash_ >> 29U);
  }

  void add_choices() {
    for (const anim::VisibleAgent& agent : stage_->posed().selection().visible) {
      add(agent.agent);
      add(agent.interval);
      add(agent.bone_level);
    }
    add(stage_->posed().selection().due.size());
  }

  void add_figures() {
    const anim::AnimationSystem& system = stage_->system();
    const anim::UpdateReport& report = system.figures().report();
    add(system.figures().pose_hash());
    add(report.palette_bytes);
    add(report.predicted_nanoseconds);
    add(report.copies.bytes_in);
    add(report.copies.bytes_out);
    add(cost_of_last_update(system).tasks);
    add(system.figures().schedule().pus);
    add(system.figures().schedule().local_store_bytes);
    add(system.figures().schedule().plan.fetch_buffers);
    add(stage_->posed().level_of_detail().figures().tolerance_px);
    add(stage_->posed().error_meter().figures().samples);
    add(stage_->posed().error_meter().figures().max);
  }

  void add_words(const auto& plain) {
    std::array<std::uint32_t, sizeof(plain) / 4> words{};
    std::memcpy(words.data(), &plain, sizeof(plain));
    for (const std::uint32_t word : words) add(word);
  }

  void add_picture(const Tuning& tuning) {
    add(tuning.bones_as_lines);
    add(tuning.scenery);
    add(tuning.light.sun_elevation);
    add(tuning.light.sun_azimuth);
    add(tuning.light.clouds);
    add(tuning.light.exposure);
    add(tuning.shadows && render::casts_shadows(tuning.light));
    add(tuning.crowd_shade);
    for (const std::uint8_t lod : stage_->posed().mesh_choice().lods()) add(lod);
    picture_.compose(*stage_);
    for (render::InstanceRecord record : picture_.instances()) {
      if (tuning.taken_away.upload) record.debug_color = 0;
      add_words(record);
      add_words(stage_->crowd().looks().drawn[record.agent]);
    }
  }

  HeapPageSource pages_{std::size_t{4} << 20U};
  Picture picture_;
  std::unique_ptr<Stage> stage_;
  render::Camera camera_ = camera_at({.x = 0, .y = 5, .z = 10, .yaw = 0, .pitch = -15});
  std::uint64_t hash_ = 0xcbf29ce484222325U;
  std::string refusal_;
};

Tuning usual(LodRule rule) {
  Tuning tuning;
  tuning.agents = agents;
  tuning.lod.rule = rule;
  tuning.system.pus = 2;
  return tuning;
}

constexpr Situation mannequins{.bone_levels = 3};

/// Tries every value of the table, and reports those whose effect is not as the function says.
void expect_effects_as_said(const Tuning& tuning, const Situation& situation, const std::string& where) {
  const std::optional<std::uint32_t> selected = situation.selected ? std::optional(0U) : std::nullopt;
  const Seen before(tuning, selected);
  ASSERT_EQ(before.refusal(), "") << where;
  for (const TuningValue& value : tuning_values()) {
    if (value.key == "cost_blender_packet_ns") continue;  // nobody blends so soon
    if (unseen.contains(value.key)) continue;
    if (value.key == "plain_bodies" && tuning.debug_view == DebugView::density) continue;  // all people have one
    if (value.key == "bone_lod" && tuning.lod.rule == LodRule::budget) continue;  // no agent is far enough away
    const auto other = other_values.find(value.key);
    ASSERT_NE(other, other_values.end()) << value.key << " needs another value in the table above";
    Tuning changed = tuning;
    value.read(changed, other->second);
    if (changed == tuning) value.read(changed, value.text(Tuning()));
    ASSERT_NE(changed, tuning) << value.key;
    const std::optional<std::string> idle = idle_reason(value.key, tuning, situation);
    const Seen after(changed, selected);
    ASSERT_EQ(after.refusal(), "") << value.key;
    EXPECT_EQ(after.hash() == before.hash(), idle.has_value())
        << where << ": " << value.key << " from " << value.text(tuning) << " to " << value.text(changed) << ", "
        << idle.value_or("is said to have an effect");
  }
}

TEST(IdleValues, TheSameTuningIsSeenTheSame) {
  const Tuning tuning = usual(LodRule::budget);
  EXPECT_EQ(Seen(tuning, {}).hash(), Seen(tuning, {}).hash());
}

TEST(IdleValues, HaveNoEffectUnderEachRuleAndAllOthersHaveOne) {
  for (const LodRule rule : {LodRule::off, LodRule::distance, LodRule::budget}) {
    expect_effects_as_said(usual(rule), mannequins, lod_rule_words.at(static_cast<std::size_t>(rule)));
  }
}

TEST(IdleValues, AreThoseOfAPausedCrowd) {
  Tuning tuning = usual(LodRule::distance);
  tuning.paused = true;
  EXPECT_TRUE(idle_reason("time_scale", tuning, {}));
  const Seen before(tuning, {});
  tuning.time_scale = 3;
  EXPECT_EQ(Seen(tuning, {}).hash(), before.hash());
}

/// Each of these makes values idle that have an effect else.
TEST(IdleValues, OfForcedIntervalsAndLevelsHaveNoEffectEither) {
  for (const LodRule rule : {LodRule::off, LodRule::distance, LodRule::budget}) {
    Tuning tuning = usual(rule);
    tuning.inspection.forced_interval = 3;
    tuning.inspection.forced_bone_level = 1;
    tuning.debug_view = DebugView::error;
    for (const char* const key :
         {"placed_feet", "full_rate_distance", "interval_growth", "largest_interval", "bone_lod", "error_sample",
          "bone_level_distance_1", "bone_level_distance_2", "bone_level_distance_3"}) {
      if (!idle_reason(key, tuning, {})) continue;
      Tuning changed = tuning;
      tuning_value(key).read(changed, other_values.at(key));
      EXPECT_EQ(Seen(changed, {}).hash(), Seen(tuning, {}).hash()) << key << ", rule " << static_cast<int>(rule);
    }
  }
}

TEST(IdleValues, AreThoseThatWouldForceASelectedAgentWhereNobodyIsSelected) {
  Tuning tuning = usual(LodRule::budget);
  tuning.inspection.force_selected_only = true;
  for (const char* const key : {"forced_interval", "forced_bone_level"}) {
    EXPECT_TRUE(idle_reason(key, tuning, {.selected = false})) << key;
    EXPECT_FALSE(idle_reason(key, tuning, {.selected = true})) << key;
    Tuning changed = tuning;
    tuning_value(key).read(changed, other_values.at(key));
    EXPECT_EQ(Seen(changed, {}).hash(), Seen(tuning, {}).hash()) << key;
  }
}

TEST(IdleValues, AreThoseOfWhatTheCrowdLacks) {
  const Tuning tuning = usual(LodRule::distance);
  const auto idle = [&](const char* key, const Situation& situation) {
    return idle_reason(key, tuning, situation).has_value();
  };
  EXPECT_TRUE(idle("placed_feet", {.places_feet = false}));
  EXPECT_TRUE(idle("palette", {.can_pack = false}));
  EXPECT_TRUE(idle("wardrobe", {.has_wardrobe = false}));
  EXPECT_TRUE(idle("bone_lod", {.bone_levels = 1}));
  EXPECT_TRUE(idle("bone_level_distance_2", {.bone_levels = 2}));
  EXPECT_FALSE(idle("bone_level_distance_1", {.bone_levels = 2}));
  EXPECT_TRUE(idle("mesh_lod", {.mesh_levels = 1}));
  EXPECT_TRUE(idle("error_px", {.mesh_levels = 1}));
  EXPECT_TRUE(idle("cost_least_task_ns", {.pus = 1}));
}

TEST(IdleValues, AreThoseOfAScaleThatIsNotShown) {
  for (const DebugView view : {DebugView::none, DebugView::speed, DebugView::density}) {
    Tuning tuning = usual(LodRule::off);
    tuning.debug_view = view;
    expect_effects_as_said(tuning, mannequins, debug_view_words.at(static_cast<std::size_t>(view)));
  }
}

TEST(IdleValues, AreTrailsOfPeopleWhoAreInNoFile) {
  Tuning tuning;
  EXPECT_TRUE(idle_reason("trail_seconds", tuning, {}));
  tuning.scene = Scene::tracks;
  EXPECT_FALSE(idle_reason("trail_seconds", tuning, {}));
  tuning.taken_away.drawing = true;
  EXPECT_TRUE(idle_reason("trail_seconds", tuning, {}));
}

TEST(IdleValues, ArePlainBodiesThatColoursCover) {
  for (const DebugView view : {DebugView::interval, DebugView::bone_level, DebugView::mesh_lod, DebugView::presence}) {
    Tuning tuning = usual(LodRule::distance);
    tuning.debug_view = view;
    const Seen before(tuning, {});
    tuning.plain_bodies = true;
    const bool is_idle = idle_reason("plain_bodies", tuning, mannequins).has_value();
    EXPECT_EQ(Seen(tuning, {}).hash() == before.hash(), is_idle) << static_cast<int>(view);
    EXPECT_EQ(is_idle, view != DebugView::presence) << static_cast<int>(view);
  }
}

TEST(IdleValues, AreWaysToLookWhereNothingIsDrawn) {
  Tuning tuning = usual(LodRule::budget);
  EXPECT_TRUE(idle_reason("split_at", tuning, {}));
  tuning.inspection.split = Split::shown;
  EXPECT_FALSE(idle_reason("split_at", tuning, {}));
  tuning.taken_away.drawing = true;
  for (const char* const key :
       {"split", "split_at", "thresholds", "debug_view", "plain_bodies", "bones_as_lines", "scenery", "pixels"}) {
    EXPECT_TRUE(idle_reason(key, tuning, {})) << key;
  }
}

}  // namespace
}  // namespace throng::app::idle_values_test
