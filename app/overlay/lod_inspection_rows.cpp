// The rows that look at level of detail, and those that try another interval or level than the rule has.
#include <algorithm>
#include <array>
#include <span>

#include "app/overlay/tabs.h"
#include "app/settings/choices.h"

namespace throng::app {
namespace {

constexpr std::array<const char*, 5> level_words = {"rule", "0", "1", "2", "3"};

void show_looking(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, commands] = context;
  LodInspection& look = tuning.inspection;
  const LodInspection& plain = standard.inspection;
  widgets.section("Look");
  widgets.toggle("Freeze LOD camera", look.freeze_camera, plain.freeze_camera,
                 {.what = "Level of detail and culling go on from where the camera is now, and you fly on. What that "
                          "camera sees is drawn as lines."});
  widgets.toggle(
      "Thresholds", look.thresholds, plain.thresholds,
      {.what = "Draws a ring on the ground wherever the interval changes, in that interval's colour. By the error "
               "limit that is for the clip that most of those in view play."});
  widgets.toggle("Above heads", look.figures_above_heads, plain.figures_above_heads,
                 {.what = "Writes each agent's interval above its head, and after an L its bone level where bones are "
                          "dropped. The 300 tallest on the screen.",
                  .cost = "Drawing words; the animation is the same."});
}

void show_split(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, commands] = context;
  LodInspection& look = tuning.inspection;
  const LodInspection& plain = standard.inspection;
  widgets.choice(
      "Split", look.split, plain.split, split_words,
      {.what = "Left of a line the exact crowd: everyone posed now, with all bones and triangles. Right of it "
               "the crowd as it is shown, or how far its picture is from the exact one, eight times as bright.",
       .cost = "Everyone in view is posed once more in full, and drawn twice."});
  if (look.split == Split::off) return;
  widgets.number("Split at", look.split_at, plain.split_at, {.lowest = 0, .highest = 1, .decimals = 2},
                 {.what = "Where the line is.", .unit = "of the picture's width"});
}

void show_forcing(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, commands] = context;
  LodInspection& look = tuning.inspection;
  const LodInspection& plain = standard.inspection;
  const int levels = level_count(report);
  widgets.section("Try");
  ImGui::BeginDisabled(tuning.lod.rule == anim::LodRule::off);
  widgets.number("Force interval", look.forced_interval, plain.forced_interval, scale_of("forced_interval"),
                 {.what = "Everyone in view is updated this rarely, whatever the rule says.",
                  .unit = "frames, 1 to 16; rule: as the rule has it"});
  ImGui::EndDisabled();
  int word = std::min(look.forced_bone_level, levels - 1) + 1;
  if (widgets.choose("Force level", word, plain.forced_bone_level + 1,
                     std::span(level_words).first(static_cast<std::size_t>(levels) + 1),
                     {.what = "Everyone in view keeps the bones of this level. rule: by distance; 0: all bones."})) {
    look.forced_bone_level = word - 1;
  }
  widgets.toggle("Selected only", look.force_selected_only, plain.force_selected_only,
                 {.what = "What is forced is forced on the selected agent only. Click at one."});
  widgets.caption("Hold X for the exact crowd.");
}

}  // namespace

void show_lod_inspection(const TabContext& context) {
  show_looking(context);
  show_split(context);
  show_forcing(context);
}

}  // namespace throng::app
