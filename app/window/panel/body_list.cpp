#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "app/character/rig_table.h"
#include "app/window/panel/tabs.h"

namespace throng::app {
namespace {

std::string label_of(anim::BodyRole part) { return capitalised(words_of(part)); }

/// Returns the place of the bone that a person says for a part, or -1.
int said_bone(const BodyParts& body, anim::BodyRole part) {
  const auto choice = std::ranges::find(body.chosen, part, &RigChoice::role);
  if (choice == body.chosen.end()) return -1;
  const auto bone = std::ranges::find(body.bones, choice->bone);
  return bone == body.bones.end() ? -1 : static_cast<int>(bone - body.bones.begin());
}

std::vector<RigChoice> with_part(const BodyParts& body, anim::BodyRole part, int bone) {
  std::vector<RigChoice> parts = body.chosen;
  std::erase_if(parts, [&](const RigChoice& choice) { return choice.role == part; });
  if (bone >= 0) parts.push_back({part, body.bones[static_cast<std::size_t>(bone)]});
  std::ranges::sort(parts, {}, &RigChoice::role);
  return parts;
}

void show_part(const TabContext& context, anim::BodyRole part) {
  const BodyParts& body = context.report.body;
  const std::string& guess = body.guessed[anim::index_of(part)];
  const std::string guessed = guess.empty() ? "guessed: none" : "guessed (" + guess + ")";
  const std::string label = label_of(part);
  int bone = said_bone(body, part);
  if (context.widgets.pick(
          label.c_str(), bone, -1, body.bones, guessed.c_str(),
          {.what = "The bone that is this part of the body. Guessed: as the file says, or as names and "
                   "shape of the skeleton suggest.",
           .cost = places_all_anew})) {
    context.requests.ask(SetBody{context.report.character, with_part(body, part, bone)});
  }
  if (body.refused != part || context.widgets.is_searching()) return;
  context.widgets.caption(body.refusal + ".");
  context.widgets.record(label + ".refusal", {.from = ImGui::GetItemRectMin(), .to = ImGui::GetItemRectMax()});
}

void show_open_list(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, requests, memory] = context;
  widgets.caption(report.body.follows);
  for (std::size_t part = 0; part < anim::body_role_count; ++part) {
    show_part(context, static_cast<anim::BodyRole>(part));
  }
  ButtonRow buttons(widgets, 2);
  buttons.ask(requests, SaveBody{}, "Save body",
              {.what = "Keeps what was chosen beside the model, in MODEL.throng.json, for next time. Size, place on "
                       "the ground and clips of other files go by it from then on."});
  buttons.ask(requests, SetBody{report.character, {}}, "Reset body",
              {.what = "Back to what is guessed, for every part."},
              report.body.chosen.empty() ? "every part is as it is guessed" : nullptr);
}

}  // namespace

void show_body(const TabContext& context) {
  bool& open = context.memory.shows_body;
  if (!context.widgets.folding_section("Body")) return;
  if (wide_button(context.widgets, open ? "Hide parts" : "Show parts",
                  {.what = "Which bone is which part of the body. Feet, gaze and falling go by it."})) {
    open = !open;
  }
  if (open || context.widgets.is_searching()) show_open_list(context);
}

}  // namespace throng::app
