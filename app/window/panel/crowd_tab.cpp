#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/character/cast_entry.h"
#include "app/settings/choices.h"
#include "app/settings/times_of_day.h"
#include "app/window/panel/controls/numbers.h"
#include "app/window/panel/tabs.h"
#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

// A single character is a fact; among several, a person picks the one whose roles and bones are shown.
void show_characters(const TabContext& context) {
  const FrameReport& report = context.report;
  if (report.characters.size() < 2) {
    const std::string file = report.characters.empty() ? "" : report.characters.front();
    context.widgets.fact(
        "Model", file_name(file),
        {.what = "The character of every agent. Drop another file, or several, on the window.", .unit = file.c_str()});
    return;
  }
  std::vector<std::string> names;
  for (const std::string& character : report.characters) names.push_back(file_name(character));
  auto shown = static_cast<int>(report.character);
  if (context.widgets.pick("Model", shown, shown, names, nullptr,
                           {.what = "The characters of the crowd: whose roles are shown below, and whose bones."})) {
    context.requests.ask(ShowCharacter{static_cast<CharacterNumber>(shown)});
  }
}

void show_who(const TabContext& context) {
  if (!context.widgets.folding_section("Who")) return;
  show_characters(context);
  if (wide_button(context.widgets, "View model",
                  {.what = "Shows the character alone, clip by clip, while the crowd waits."})) {
    context.requests.ask(View{{.character = context.report.character}});
  }
  const bool has_others = !context.report.has_built_in_cast;
  if (has_others && wide_button(context.widgets, "Back to the built-in people",
                                {.what = "Gives all agents the character that comes with the program. Ctrl+Z takes it "
                                         "back."})) {
    context.requests.ask(SetCast{{ChosenCharacter{}}});
  }
  context.row("scene", {.what = "plaza: people cross, stop and talk. parade: companies march past spectators. "
                                "stadium: seats on tiers, and a wave that runs round. grid: everyone stands in rows. "
                                "film: a cut scene with an actor, a balloon and a camera.",
                        .cost = places_all_anew});
  context.row("agents", {.what = "Characters in the crowd, each in a pose of its own.",
                         .unit = "1 to 100,000",
                         .cost = "Animation grows with agents in view, memory with all of them."});
  context.row("seed", {.what = "Decides phases, speeds, heights, colours and places. The same seed is the same crowd.",
                       .unit = "0 to 4,294,967,295; the track reaches 9,999",
                       .cost = places_all_anew});
  context.row("variety",
              {.what = "Agents of one character differ in height, colours and build, as the next two rows say. Off: "
                       "they are all as its file has it.",
               .cost = places_all_anew});
  context.row("tint",
              {.what = "How much agents differ in colours: 1 as much as they can, 0 not at all. A model whose colours "
                       "are its file's own gets lighter, darker, warmer and cooler.",
               .cost = places_all_anew});
  context.row(
      "size_variety",
      {.what = "How much agents differ in size, as a share of it.", .unit = "0 to 0.3", .cost = places_all_anew});
  context.row("clothes",
              {.what = "own: each person wears colours of their own. pattern: colours by place, which make one "
                       "large shape that is seen from above; the camera tower shows it.",
               .cost = places_all_anew});
  context.row(
      "placed_feet",
      {.what = "Feet stay where they came down, of people near by, or of all where the rule of LOD is off. Off: "
               "feet move as the clip has them, and slide in turns.",
       .cost = "Some microseconds an agent."});
}

constexpr double usual_most_share = 100;

// Names that two share are told apart by the place in the cast.
std::string cast_label(const std::vector<std::string>& names, std::size_t character) {
  const std::string name = file_name(names[character]);
  const auto is_same = [&](const std::string& other) { return file_name(other) == name; };
  return std::ranges::count_if(names, is_same) < 2 ? name : std::to_string(character + 1) + " " + name;
}

void show_cast(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, requests, memory] = context;
  if (report.characters.size() < 2 || report.cast.size() != report.characters.size()) return;
  if (!widgets.folding_section("Cast")) return;
  const bool counts_heads =
      std::ranges::any_of(report.cast, [](const CastMember& member) { return member.share > usual_most_share; });
  const NumberScale scale{.lowest = least_share,
                          .highest = counts_heads ? most_share : usual_most_share,
                          .decimals = 2,
                          .logarithmic = true};
  for (std::size_t character = 0; character < report.cast.size(); ++character) {
    const CastMember& member = report.cast[character];
    const std::string label = cast_label(report.characters, character);
    const std::string agents =
        counted(static_cast<std::size_t>(member.agents), "agent") + " now. A share counts beside those of the others.";
    double share = member.share;
    const Help help{.what = agents.c_str(), .cost = places_all_anew};
    if (widgets.number(label.c_str(), share, member.starting_share, scale, help))
      requests.ask(SetShare{static_cast<CharacterNumber>(character), share});
  }
  std::string counts;
  for (const CastMember& member : report.cast) {
    counts += (counts.empty() ? "" : " + ") + with_thousands(member.agents);
  }
  widgets.caption(counts + " agents");
  const std::string words = "Everyone is " + cast_label(report.characters, report.character);
  const Help help{.what =
                      "The model chosen above takes all places that it can stand or walk in. The others stay in the "
                      "cast."};
  if (widgets.named_button(words.c_str(), "Everyone is this", help, ImGui::GetContentRegionAvail().x)) {
    for (std::size_t i = 0; i < report.cast.size(); ++i) {
      requests.ask(SetShare{static_cast<CharacterNumber>(i), i == report.character ? most_share : least_share});
    }
  }
}

std::uint32_t nearest_snapshot(const std::vector<float>& ages, double seconds) {
  const auto distance = [seconds](float age) { return std::abs(static_cast<double>(age) - seconds); };
  return static_cast<std::uint32_t>(std::ranges::min_element(ages, {}, distance) - ages.begin());
}

const char* why_no_snapshot(const FrameReport& report) {
  return report.tracks ? "the timeline at the foot of the crowd goes to any moment" : "there is no snapshot yet";
}

// The crowd goes back where the slider is let go, since on the way there each snapshot would take its place.
void show_snapshots(const TabContext& context) {
  const std::vector<float>& ages = context.report.snapshots;
  std::optional<double>& seconds_back = context.memory.seconds_back;
  const bool none = ages.empty();
  const char* const why = why_no_snapshot(context.report);
  double seconds = seconds_back.value_or(0);
  context.widgets.begin_idle(none ? std::optional<std::string>(why) : std::nullopt);
  if (context.widgets.number(
          "Back by", seconds, 0,
          {.highest = none ? 1 : static_cast<double>(ages.back()), .decimals = 1, .zero_word = "now", .suffix = " s"},
          {.what =
               "Where it is let go, the crowd goes back to the nearest of up to ten snapshots, one each half second. "
               "From there everything happens as it did.",
           .unit = "seconds of the crowd's clock",
           .cost = "Memory of ten crowds; none are taken above 20,000 agents."})) {
    seconds_back = seconds;
  }
  context.widgets.end_idle();
  if (!seconds_back || ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
  if (*seconds_back > 0 && !none) context.requests.ask(GoBack{nearest_snapshot(ages, *seconds_back)});
  seconds_back.reset();
}

void show_time(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, requests, memory] = context;
  const std::vector<float>& ages = report.snapshots;
  if (!widgets.folding_section("Time")) return;
  context.row("paused", {.what = "Holds the crowd; the camera still flies. Space does the same."});
  context.row("time_scale", {.what = "How fast the crowd's clock runs.", .unit = "times real time, 0 to 4"});
  show_snapshots(context);
  ButtonRow buttons(widgets, 2);
  buttons.ask(requests, StepFrame{}, "Step", {.what = "One frame onwards, while paused."},
              tuning.paused ? nullptr : "the crowd is not paused");
  buttons.ask(requests, GoBack{0}, "Rewind",
              {.what = "Back to the newest snapshot; pressed again, to the one before it."},
              ages.empty() ? why_no_snapshot(report) : nullptr);
  if (report.tracks) return;
  widgets.caption(ages.empty()
                      ? "No snapshot yet."
                      : counted(ages.size(), "snapshot") + ", the newest " + fixed(ages.front(), 1) + " s ago.");
}

void show_light(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, requests, memory] = context;
  if (!widgets.folding_section("Light")) return;
  ButtonRow buttons(widgets, static_cast<int>(times_of_day.size()));
  for (const TimeOfDay& time : times_of_day) {
    if (buttons.button(time.name, {.what = "Puts sun and clouds where they are at this time."}))
      tuning.light = time.light;
  }
  context.row("sun_elevation",
              {.what = "How high the sun stands. Below 5 windows and lamps come on; below -2 the moon shines.",
               .unit = "degrees above the horizon",
               .cost = "The sky is made anew, some 50 ms."});
  context.row("sun_azimuth", {.what = "Where the sun stands: 0 is +Z, 90 is +X.", .unit = "degrees"});
  context.row("clouds",
              {.what = "How much of the sky clouds cover. At 1 the sun is behind them and casts no shadows."});
  context.row("exposure",
              {.what = "How bright the picture is. 0 suits the light.", .unit = "stops; each doubles the light"});
  context.row("shadows", {.what = "People and things cast shadows.",
                          .cost = "Each agent is drawn once or twice more, with coarser meshes."});
  context.row("crowd_shade", {.what = "Bodies darken each other and the ground between them, where they hide the sky.",
                              .cost = "One draw of small squares, and one texture read a pixel."});
}

struct RoleRow {
  Role role;
  const char* label;
  const char* what;
};

constexpr RoleRow role_rows[] = {
    {Role::stand, "Stand", "The clip of people who stand. Without one, agents repeat what clips there are, in place."},
    {Role::look_around, "Look around", "The clip of people who stop to look. Without one they stand."},
    {Role::walk, "Walk", "The clip of people who walk. Without one all stand."},
    {Role::jog, "Jog", "The clip of people who jog. Without one they walk."},
    {Role::run, "Run", "The clip of people who run. Without one they jog or walk."},
    {Role::wave, "Wave", "The clip of people who greet another."},
    {Role::cheer, "Cheer", "The clip of people who cheer, and of the stadium's wave."},
    {Role::clap, "Clap", "The clip of people who applaud."},
    {Role::sit, "Sit", "The clip of people who have a seat. Without one they stand."},
    {Role::walk_back, "Walk back", "The clip of people who step back where a file of trajectories says so."},
    {Role::step_left, "Step left", "The clip of people who step to their left where a file of trajectories says so."},
    {Role::step_right, "Step right",
     "The clip of people who step to their right where a file of trajectories says so."},
    {Role::shuffle, "Shuffle", "The clip of people who move on in a jam, where a file of trajectories says so."},
    {Role::step_in_place, "Step in place", "The clip of people who hardly move, where a file of trajectories says so."},
    {Role::veer_left, "Veer left",
     "The clip of people who walk on and a little to their left, by a file of trajectories."},
    {Role::veer_right, "Veer right",
     "The clip of people who walk on and a little to their right, by a file of trajectories."},
    {Role::talk, "Talk", "The clip of people who talk to a neighbour, in a file of trajectories."},
};

void show_role(const TabContext& context, const RoleRow& row, RoleClips& clips) {
  const FrameReport& report = context.report;
  const std::size_t role = index_of(row.role);
  const int before = clips[role];
  context.widgets.pick(row.label, clips[role], report.suggested_role_clips[role], report.clip_names, no_clip_name,
                       {.what = row.what, .cost = "Another clip is shown on one character before the crowd plays it."});
  if (clips[role] == before || clips[role] == no_clip) return;
  context.requests.ask(View{{.character = report.character, .preview = RolePreview{row.role, clips[role]}}});
  clips[role] = before;
}

void show_roles(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, requests, memory] = context;
  if (!widgets.folding_section("Roles")) return;
  RoleClips clips = report.role_clips;
  const auto show_all = [&](bool of_scenes) {
    for (const RoleRow& row : role_rows) {
      if ((row.role < Role::walk_back) == of_scenes) show_role(context, row, clips);
    }
  };
  show_all(true);
  ButtonRow buttons(widgets, 3);
  buttons.ask(requests, SaveRoles{}, "Save roles",
              {.what = "Keeps them beside the model, in MODEL.throng.json, for next time."});
  const bool resets = buttons.button("Reset roles", {.what = "Back to what the clips' names suggest."});
  bool& open = memory.shows_gaits;
  if (buttons.button(open ? "Hide gaits" : "Show gaits",
                     {.what = "The roles of people who are led by a file of trajectories: aside, back, in a jam."})) {
    open = !open;
  }
  if (open || widgets.is_searching()) show_all(false);
  if (resets) clips = report.suggested_role_clips;
  if (clips != report.role_clips) requests.ask(SetRoles{report.character, clips});
}

void show_in_view(const TabContext& context) {
  const FrameReport& report = context.report;
  Widgets& widgets = context.widgets;
  const auto count = [](auto value) { return with_thousands(static_cast<std::uint64_t>(value)); };
  if (!widgets.folding_section("In this frame")) return;
  widgets.fact("In view", count(report.visible) + " of " + count(report.agents),
               {.what = "Agents inside the camera's frustum."});
  widgets.fact("Poses computed", count(report.work.agents_updated),
               {.what = "Agents updated in this frame; the others blend towards the pose they were given earlier."});
  widgets.fact("Bones evaluated", count(report.work.bones_evaluated),
               {.what = "Over all agents updated in this frame."});
  widgets.fact("Draw calls", count(report.draw_counts.draw_calls),
               {.what = "They do not grow with the crowd: mesh LODs times materials times palette pages at most."});
  widgets.fact("Triangles", count(report.draw_counts.triangles), {.what = "Of the crowd, after culling and mesh LOD."});
}

}  // namespace

void show_crowd_tab(const TabContext& context) {
  show_who(context);
  show_cast(context);
  show_wardrobe(context);
  show_time(context);
  show_picture_section(context);
  show_camera_section(context);
  show_light(context);
  context.when_not_searching(show_in_view);
  show_model(context);
  show_roles(context);
  show_body(context);
}

}  // namespace throng::app
