// The size and place of the character shown, in Crowd.
#include <algorithm>

#include "app/settings/choices.h"
#include "app/settings/option_values.h"
#include "app/window/panel/tabs.h"

namespace throng::app {
namespace {

using anim::PlacementChoice;

// Loading takes time, so a value that is dragged counts once it is let go.
void send_when_let_go(const TabContext& context) {
  std::optional<SetPlacement>& wanted = context.memory.placement;
  if (!wanted || ImGui::IsAnyItemActive()) return;
  const bool is_new =
      wanted->character == context.report.character && wanted->choice != context.report.placement.choice;
  if (is_new) context.requests.ask(*wanted);
  wanted.reset();
}

// The guess is no number that was asked for.
std::optional<double> asked_scale(double scale, double guessed) {
  return scale == guessed ? std::nullopt : std::optional(std::clamp(scale, least_scale, most_scale));
}

void show_size(const TabContext& context, PlacementChoice& choice) {
  const PlacementReport& placement = context.report.placement;
  double scale = choice.scale.value_or(placement.guessed_scale);
  const NumberScale scales{.lowest = least_scale, .highest = most_scale, .decimals = 6, .logarithmic = true};
  if (context.widgets.number("Scale", scale, placement.guessed_scale, scales,
                             {.what = "Metres that a unit of its file is. Reset: as it is guessed from its size.",
                              .cost = "The character is loaded anew; all agents begin anew."})) {
    choice.scale = asked_scale(scale, placement.guessed_scale);
  }
  if (placement.units_tall <= 0.0) return;
  double height = scale * placement.units_tall;
  const NumberScale heights{.lowest = 0.01, .highest = 100.0, .decimals = 3, .logarithmic = true, .suffix = " m"};
  if (context.widgets.number("Height", height, placement.guessed_scale * placement.units_tall, heights,
                             {.what = "How tall it is, by the same scale.", .unit = "metres"})) {
    choice.scale = height == placement.guessed_scale * placement.units_tall
                       ? std::nullopt
                       : asked_scale(height / placement.units_tall, placement.guessed_scale);
  }
}

}  // namespace

void show_model(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, requests, memory] = context;
  if (report.characters.empty()) return;
  if (!widgets.folding_section("Model")) return;
  const bool is_dragged = memory.placement && memory.placement->character == report.character;
  const PlacementChoice before = is_dragged ? memory.placement->choice : report.placement.choice;
  PlacementChoice choice = before;
  show_size(context, choice);
  widgets.choice("Up axis", choice.up, anim::UpAxis::y, up_axis_words,
                 {.what = "The axis of its file that points up. glTF says y; some files lie on their backs."});
  widgets.choice("Ground", choice.ground, anim::GroundRule::guess, ground_words,
                 {.what = "What stands on the ground. guess: the file's origin, unless the body is far from it or "
                          "reaches below it. file: its origin. feet: its lowest point."});
  widgets.caption(report.placement.reasons + ".");
  if (choice != before) memory.placement = SetPlacement{report.character, choice};
  send_when_let_go(context);
}

}  // namespace throng::app
