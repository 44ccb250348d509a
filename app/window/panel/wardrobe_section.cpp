// Draws the section Wardrobe of the tab Crowd.
#include <algorithm>

#include "app/settings/preset.h"
#include "app/window/panel/controls/numbers.h"
#include "app/window/panel/tabs.h"

namespace throng::app {
namespace {

constexpr double most_on_track = 100, most_things_on_track = 10;
constexpr const char* cost_of_dressing = "All people change their clothes and get new places.";

// Dressing takes time, so a value that is dragged counts once it is let go.
void dress_when_let_go(const TabContext& context) {
  std::optional<TuneRules>& wanted = context.memory.rules;
  if (!wanted || ImGui::IsAnyItemActive()) return;
  const bool is_new = wanted->character == context.report.character && wanted->tuning != context.report.wardrobe.tuning;
  if (is_new) context.requests.ask(*wanted);
  wanted.reset();
}

float standard_of(const WeighedNames& standard, const WeighedName& name) {
  const auto found = std::ranges::find(standard, name.name, &WeighedName::name);
  return found == standard.end() ? name.weight : found->weight;
}

void show_weights(const TabContext& context, const std::string& before, const char* what, const WeighedNames& standard,
                  WeighedNames& names) {
  for (WeighedName& name : names) {
    if (name.name.empty()) continue;  // the one body of a file that names none
    const NumberScale scale{.highest = std::max(most_on_track, static_cast<double>(name.weight)), .decimals = 1};
    const std::string label = before.empty() ? capitalised(name.name) : before + name.name;
    context.widgets.number(label.c_str(), name.weight, standard_of(standard, name), scale,
                           {.what = what, .unit = "a share beside the others", .cost = cost_of_dressing});
  }
}

void show_things(const TabContext& context, CastTuning& tuning) {
  const NumberScale scale{
      .highest = most_things_on_track, .decimals = 1, .suffix = " times", .most_typed = most_things};
  context.widgets.number(
      "Things in hands", tuning.things, context.report.wardrobe.standard.things, scale,
      {.what = "How much more often people hold a bag, a phone or an umbrella than their "
               "styles say. 0: only people who take pictures. A person who holds a thing uses it now and then.",
       .cost = cost_of_dressing});
}

void show_styles(const TabContext& context, CastTuning& tuning) {
  const bool open = context.memory.shows_styles || context.widgets.is_searching();
  if (open) {
    show_weights(context, "Style ", "How many of this scene dress so.", context.report.wardrobe.standard.styles,
                 tuning.styles);
  }
}

void show_rule_buttons(const TabContext& context, CastTuning& tuning) {
  ButtonRow buttons(context.widgets, 3);
  if (buttons.button("Dress anew", {.what = "All people get other clothes by the same rules, from another seed.",
                                    .cost = cost_of_dressing})) {
    ++tuning.seed;
  }
  bool& open = context.memory.shows_styles;
  if (buttons.button(open ? "Hide styles" : "Show styles", {.what = "The styles of this scene, with their shares."})) {
    open = !open;
  }
  const CastTuning& standard = context.report.wardrobe.standard;
  if (buttons.button("Reset rules", {.what = "Back to what the file of rules says.", .cost = cost_of_dressing},
                     tuning == standard ? "the rules are as their file says" : nullptr)) {
    tuning = standard;
  }
}

void show_rule_files(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, requests, memory] = context;
  std::string& name = memory.rules_name;
  widgets.text("Rules", name, "letters, digits, - and _",
               {.what = "NAME of NAME.cast.json, in the working folder: a file of rules to edit by hand. "
                        "--cast NAME.cast.json starts with it."});
  const bool is_named = can_name_a_preset(name);
  ButtonRow buttons(widgets, 2);
  buttons.ask(requests, SaveRules{name}, "Save rules",
              {.what = "Writes all rules as they are now. A file of that name is replaced."},
              is_named ? nullptr : "a name has letters, digits, - and _");
  const bool has_file = is_named || (name.empty() && !report.wardrobe.file.empty());
  buttons.ask(requests, LoadRules{name}, "Load rules",
              {.what = "Reads NAME.cast.json; without a name, the file of the rules once more, with what was "
                       "edited in it.",
               .cost = cost_of_dressing},
              has_file ? nullptr : "the rules come from no file; give a name");
}

std::string origin_of_rules(const WardrobeReport& report) {
  if (report.file.empty()) return "Rules of no file.";
  return "Rules of " + file_name(report.file) + (report.tuning == report.standard ? "." : ", changed.");
}

}  // namespace

void show_wardrobe(const TabContext& context) {
  Widgets& widgets = context.widgets;
  const FrameReport& report = context.report;
  TabMemory& memory = context.memory;
  if (!widgets.folding_section("Wardrobe")) return;
  context.row("wardrobe",
              {.what = "People wear what rules draw for them out of the parts of their character: women, men and "
                       "children, each in an outfit. Off: all wear what the file shows.",
               .cost = places_all_anew});
  context.row("weather", {.what = "What people dress for, and hold in their hands. Rules say which clothes are for it.",
                          .cost = places_all_anew});
  if (report.wardrobe.tuning.bodies.empty()) return;
  context.unless_idle("weather", [&] {
    const bool is_dragged = memory.rules && memory.rules->character == report.character;
    const CastTuning before = is_dragged ? memory.rules->tuning : report.wardrobe.tuning;
    CastTuning cast = before;
    show_weights(context, "", "How many of the crowd have this body.", report.wardrobe.standard.bodies, cast.bodies);
    show_things(context, cast);
    show_styles(context, cast);
    show_rule_buttons(context, cast);
    if (cast != before) memory.rules = TuneRules{report.character, cast};
    show_rule_files(context);
  });
  widgets.caption(with_thousands(report.wardrobe.holding) + " of " + with_thousands(report.agents) +
                  " hold something. " + origin_of_rules(report.wardrobe));
  dress_when_let_go(context);
}

}  // namespace throng::app
