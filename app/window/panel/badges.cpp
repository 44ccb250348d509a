#include "app/window/panel/badges.h"

#include "app/window/panel/cards.h"

namespace throng::app {
namespace {

std::string clock_text(double seconds) {
  const auto whole = static_cast<int>(seconds);
  const std::string rest = std::to_string(whole % 60);
  return std::to_string(whole / 60) + ":" + (rest.size() < 2 ? "0" : "") + rest;
}

std::string forced_for(const TabContext& context) {
  if (!context.tuning.inspection.force_selected_only) return " for all agents";
  return context.report.selected ? " for " + name_of(*context.report.selected) : " for the selected agent";
}

std::string taken_away_words(const TakenAway& away) {
  std::string words;
  const auto add = [&](bool is_away, const char* word) {
    if (is_away) words += (words.empty() ? "No " : ", no ") + std::string(word);
  };
  add(away.animation, "animation");
  add(away.upload, "upload");
  add(away.drawing, "drawing");
  add(away.pixels, "pixels");
  return words;
}

}  // namespace

std::vector<Badge> badges_of(const TabContext& context) {
  const Tuning& tuning = context.tuning;
  const LodInspection& look = tuning.inspection;
  const FrameReport& report = context.report;
  std::vector<Badge> badges;
  const auto add_if = [&](bool holds, Badge badge) {
    if (holds) badges.push_back(std::move(badge));
  };
  add_if(!report.recording.file.empty(),
         {"recording", colour::recording,
          "Records " + report.recording.file + "   " + clock_text(report.messages.now() - report.recording.began_at),
          "All that happens goes into that file. A click or R ends it.",
          [](const TabContext& ended) { ended.requests.ask(ToggleRecording{}); }});
  const TuningPair& pair = context.memory.pair;
  add_if(pair.has_two(), {"pair", colour::accent, pair.title_in_use() + " is in use",
                          pair.other_title() + " waits. A click or B changes their places. The tab Presets ends it.",
                          [](const TabContext& ended) { ended.memory.pair.change_places(ended.tuning); }});
  add_if(context.widgets.focus().has_keys(),
         {"keys", colour::accent, "The keyboard is in the panel",
          "Arrows go from widget to widget and change values, Enter acts. A click, F6 or Esc gives the keyboard back.",
          [](const TabContext& ended) { ended.widgets.focus().give_back(); }});
  add_if(tuning.paused, {"paused", colour::frame, "Paused", "A click or Space goes on.",
                         [](const TabContext& ended) { ended.tuning.paused = false; }});
  add_if(last_of<ShowExactCrowd>(context.requests) != nullptr,
         {"exact", colour::accent, "The exact crowd", "As long as X is held, nothing is skipped and nothing dropped."});
  add_if(look.freeze_camera, {"frozen", colour::accent, "LOD camera frozen",
                              "Level of detail goes on from where the camera was frozen. A click lets it go.",
                              [](const TabContext& ended) { ended.tuning.inspection.freeze_camera = false; }});
  add_if(look.split != Split::off, {"split", colour::accent,
                                    look.split == Split::shown ? "Left of the line exact, right as shown"
                                                               : "Left of the line exact, right the difference times 8",
                                    "A click shows one crowd again.",
                                    [](const TabContext& ended) { ended.tuning.inspection.split = Split::off; }});
  add_if(look.forced_interval > 0,
         {"interval", colour::changed, "Interval " + std::to_string(look.forced_interval) + forced_for(context),
          "The rule does not decide how often they are updated. A click lets it decide.",
          [](const TabContext& ended) { ended.tuning.inspection.forced_interval = 0; }});
  add_if(look.forced_bone_level >= 0,
         {"level", colour::changed, "Bone level " + std::to_string(look.forced_bone_level) + forced_for(context),
          "The rule does not decide how many bones they keep. A click lets it decide.",
          [](const TabContext& ended) { ended.tuning.inspection.forced_bone_level = -1; }});
  add_if(tuning.taken_away != TakenAway{},
         {"taken_away", colour::changed, taken_away_words(tuning.taken_away),
          "A part of the frame is left out, to show what it costs. A click brings all back.",
          [](const TabContext& ended) { ended.tuning.taken_away = {}; }});
  add_if(report.sweep.runs, {"sweep", colour::accent, "Sweep", "One value goes through its range. A click ends it.",
                             [](const TabContext& ended) { ended.requests.ask(StopSweep{}); }});
  return badges;
}

}  // namespace throng::app
