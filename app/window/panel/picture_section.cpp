// What is drawn in which colours, in which size and how well, in Crowd.
#include <algorithm>

#include "app/settings/quality.h"
#include "app/window/panel/tabs.h"

namespace throng::app {
namespace {

// The values of the view in force alone have rows, or all while they are searched.
void show_scale(const TabContext& context) {
  const DebugView view = context.tuning.debug_view;
  const bool shows_all = context.widgets.is_searching();
  const Help help{.what = "What the last colour of the scale stands for. Above it people have that colour too."};
  if (shows_all || view == DebugView::speed) context.row("top_speed", help);
  if (shows_all || view == DebugView::density) context.row("top_density", help);
  if (shows_all || view == DebugView::density) {
    context.row("density_cut_off", {.what = "How far a person's own ground reaches where no other person is near, as "
                                            "PedPy's cut_off. A smaller one makes people at the edge denser.",
                                    .unit = "metres, 0.1 to 10"});
  }
  if (shows_all || view == DebugView::presence) context.row("top_presence", help);
}

// Setting a quality by its name ends the holding of a frame rate.
void show_quality(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, requests, memory] = context;
  ButtonRow buttons(widgets, static_cast<int>(qualities.size()) + 1);
  for (const Quality& quality : qualities) {
    if (!buttons.button(quality.name, {.what = "Sets picture size, triangle limit, shadows and crowd shade together."}))
      continue;
    take_quality(quality.name, tuning);
  }
  if (buttons.button(automatic_quality,
                     {.what = "Holds the frame rate: gives up shadows, triangles and picture size while frames "
                              "take too long, and takes them back where there is time."}))
    tuning.holds_rate = true;
  context.row("holds_rate", {.what = "Gives up shadows, triangles and picture size while frames take too long, and "
                                     "takes them back where there is time. What you set by hand stays."});
  context.row("frame_rate", {.what = "The frames a second that are held.", .unit = "5 to 240"});
  context.row("frame_limit",
              {.what = "Shows no more frames a second than these, which spares battery and fan.", .unit = "0 to 240"});
  context.row("vertical_sync", {.what = "Shows a frame when the display is refreshed, so that no picture is torn. Off "
                                        "shows each frame at once.",
                                .cost = "A frame waits for the next refresh."});
  if (!report.given_up.empty()) widgets.caption(report.given_up);
  if (report.rate_advice.empty()) return;
  widgets.caption(report.rate_advice);
  if (wide_button(widgets, "Hold the frame rate", {.what = "Sets quality auto."})) tuning.holds_rate = true;
}

void show_picture_files(const TabContext& context, OutputChoices& choices) {
  Widgets& widgets = context.widgets;
  double times = choices.picture_times;
  widgets.number("Picture times", times, OutputChoices().picture_times,
                 {.lowest = 1, .highest = most_picture_times, .suffix = " x"},
                 {.what = "A full picture has so many times the window's width and height.",
                  .unit = "1 to 4",
                  .cost = "Twice the size takes four times as long."});
  choices.picture_times = static_cast<int>(times);
  ButtonRow buttons(widgets, 2);
  buttons.ask(context.requests, TakeScreenshot{}, "Screenshot",
              {.what = "Writes the picture of the window as a PNG, with the panel. Key F12."});
  buttons.ask(context.requests, TakeStill{}, "Full picture",
              {.what = "Writes the picture without the panel as a PNG, in the quality of a run without a window: whole "
                       "size, smooth edges, shadows, no triangle limit but one set by hand. Shift and F12.",
               .cost = "A frame that takes a second or more."});
}

void show_video(const TabContext& context, OutputChoices& choices) {
  const auto& [widgets, report, tuning, standard, requests, memory] = context;
  widgets.number("Video length", choices.video_seconds, OutputChoices().video_seconds,
                 {.lowest = least_video_seconds, .highest = most_video_seconds, .logarithmic = true, .suffix = " s"},
                 {.what = "How long a video from now on is. That of a recorded crowd is as long as its part.",
                  .unit = "seconds, 1 to 600"});
  const bool is_made = std::ranges::find(report.jobs, SideJob::video, &JobReport::job) != report.jobs.end();
  ButtonRow buttons(widgets, 2);
  buttons.ask(requests, MakeVideo{}, "Make video",
              {.what = "Makes throng-1.mp4 in full quality while the window goes on, seen by the camera as it is now: "
                       "the part of a recorded crowd once, or another crowd from now on. There people who walk about "
                       "may be a step or two from where they are here, as the crowd is made again. Needs ffmpeg. "
                       "Key V."},
              is_made ? "A video is being made. Its card has the button that ends it." : nullptr);
  buttons.ask(requests, CopyCamera{}, "Copy camera",
              {.what = "Puts the camera as an option into the clipboard. Key C."});
}

}  // namespace

void show_picture_section(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, requests, memory] = context;
  if (!widgets.folding_section("Picture")) return;
  show_quality(context);
  context.row(
      "debug_view",
      {.what = "none: people's own clothes. interval: frames between updates. bones: per-bone LOD level. "
               "mesh: mesh LOD. Dark colours are full detail, light ones the coarsest. speed, density: how fast "
               "people go, how close they stand. presence: since when they are there."});
  show_scale(context);
  context.row("plain_bodies",
              {.what = "Bodies are grey where the colours above give them none, without the colours and "
                       "textures of clothes, so that colours and trails are read well."});
  context.row(
      "picture_size",
      {.what = "Draws the crowd in a part of the window's width and height, and stretches it. The panel and its "
               "texts stay sharp.",
       .unit = "per cent, 25 to 100",
       .cost = "Half the size has a quarter of the pixels, and coarser meshes in it."});
  context.row("trail_seconds",
              {.what = "Draws where people of a recorded crowd went in the last seconds, on the ground.",
               .unit = "seconds, 0 to 30",
               .cost = "Some lines for each of them."});
  context.row("ids", {.what = "Writes the id that a person has in a file above each head, or else the number of the "
                              "agent. The nearest come first; an id without room is left out.",
                      .cost = "The 300 nearest heads are looked at."});
  context.row("bones_as_lines",
              {.what = "Draws the skeletons over the characters. Behind another character they show through faintly.",
               .cost = "Two draws a bone and agent in view."});
  context.row("scenery", {.what = "Draws houses, trees and seats around the crowd. It walks around them in any case.",
                          .cost = "One draw call, and the triangles in view."});
  OutputChoices choices = report.output;
  show_picture_files(context, choices);
  show_video(context, choices);
  if (choices != report.output) requests.ask(SetOutput{choices});
}

}  // namespace throng::app
