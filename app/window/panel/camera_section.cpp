// The cameras, in the tab Crowd.
#include <algorithm>
#include <span>
#include <string>
#include <string_view>

#include "app/show/camera/fly_camera.h"
#include "app/show/camera/scenes.h"
#include "app/window/panel/cards.h"
#include "app/window/panel/tabs.h"

namespace throng::app {
namespace {

constexpr const char* what_top_is =
    "Looks down as a plan does, with the file's y up: from so far away, with so narrow a view, that there is hardly "
    "any "
    "perspective. It is no orthographic projection: at the edge a head lies up to 12 cm farther out than its feet.";

void show_scene_cameras(const TabContext& context) {
  constexpr std::size_t in_a_row = 4;
  const std::span<const char* const> names = scene_camera_names(context.tuning.scene);
  for (std::size_t first = 0; first < names.size(); first += in_a_row) {
    ButtonRow buttons(context.widgets, static_cast<int>(in_a_row));
    for (std::size_t i = first; i < std::min(first + in_a_row, names.size()); ++i) {
      const bool is_plan = std::string_view(names[i]) == "top";
      const bool pressed =
          buttons.button(names[i], {.what = is_plan ? what_top_is : "Goes to this camera of the scene."});
      if (pressed) context.requests.ask(GoToCamera{i});
    }
  }
}

void show_ways_to_go(const TabContext& context) {
  const CameraReport& cameras = context.report.cameras;
  ButtonRow buttons(context.widgets, 2);
  buttons.ask(context.requests, GoHome{}, "Home",
              {.what = "Back to where the scene's camera begins. A film or a path has the camera again. Key Home."});
  buttons.ask(context.requests, FrameCrowd{}, "Frame crowd",
              {.what = "Moves the camera until all agents are seen beside the panel. Key F."});
  const char* const why_not = context.report.selected ? nullptr : "No agent is selected. Click at one first.";
  ButtonRow follow(context.widgets, 2);
  follow.ask(context.requests, ToggleFollow{}, cameras.follows ? "Stop following" : "Follow",
             {.what = "The camera goes where the selected agent goes, from where it is now. Key G."}, why_not);
  follow.ask(context.requests, FollowBehind{}, "From behind",
             {.what = "The camera goes behind the selected agent and turns with it. Shift and G. Alt and a drag "
                      "go round."},
             why_not);
}

// Says what moves the camera, where that is not the person alone.
void say_who_moves_it(const TabContext& context) {
  const CameraReport& cameras = context.report.cameras;
  if (cameras.films) {
    context.widgets.caption("A film, a path or a live crowd moves the camera. Fly, and it is yours.");
  } else if (cameras.follows && context.report.selected) {
    context.widgets.caption("The camera follows " + name_of(*context.report.selected) + ".");
  } else if (cameras.can_film) {
    context.widgets.caption("The camera is yours. Home gives it back to the film or the path.");
  }
}

void show_bookmarks(const TabContext& context) {
  const Help help{.what =
                      "A place of the camera. The first click keeps the place, later ones go there; Ctrl and a "
                      "click keep another one. Keys 1 to 9, and Ctrl with them."};
  ButtonRow buttons(context.widgets, static_cast<int>(bookmark_count));
  for (std::size_t i = 0; i < bookmark_count; ++i) {
    const bool is_kept = context.report.cameras.kept.at(i);
    const std::string digit = std::to_string(i + 1);
    if (!buttons.marked_button(digit.c_str(), "Bookmark " + digit, help, is_kept)) continue;
    const bool goes = is_kept && !ImGui::GetIO().KeyCtrl;
    context.requests.ask(goes ? CameraRequest(GoToBookmark{i}) : CameraRequest(KeepBookmark{i}));
  }
}

}  // namespace

void show_camera_section(const TabContext& context) {
  Widgets& widgets = context.widgets;
  if (!widgets.folding_section("Camera")) return;
  show_scene_cameras(context);
  show_ways_to_go(context);
  say_who_moves_it(context);
  widgets.caption("Bookmarks");
  show_bookmarks(context);
  float speed = context.report.cameras.fly_speed;
  const NumberScale scale{.lowest = static_cast<double>(lowest_fly_speed),
                          .highest = static_cast<double>(highest_fly_speed),
                          .decimals = 2,
                          .logarithmic = true,
                          .suffix = " m/s"};
  if (widgets.number("Flying speed", speed, usual_fly_speed, scale,
                     {.what = "How fast W A S D and Q E fly; the wheel over the crowd changes it too. Shift is four "
                              "times as fast, Ctrl a quarter.",
                      .unit = "metres a second"})) {
    context.requests.ask(SetFlySpeed{speed});
  }
  if (widgets.is_searching()) return;
  const CameraPose& camera = context.report.camera;
  const auto number = [](float value) { return fixed(value, 1); };
  widgets.fact("Camera at", number(camera.x) + ", " + number(camera.y) + ", " + number(camera.z),
               {.what = "Where the camera stands.", .unit = "metres"});
  widgets.fact("Looks", number(camera.yaw) + "\xC2\xB0 yaw, " + number(camera.pitch) + "\xC2\xB0 pitch",
               {.what = "Yaw 0 looks along -Z; a positive pitch looks up.", .unit = "degrees"});
  widgets.fact("Field of view", number(camera.field_of_view) + "\xC2\xB0",
               {.what = "How much the picture sees from its top to its bottom.", .unit = "degrees"});
}

}  // namespace throng::app
