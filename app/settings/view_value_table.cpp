#include "app/settings/choices.h"
#include "app/settings/tuning_value_kinds.h"
#include "app/settings/tuning_value_table.h"

namespace throng::app {
namespace {

// The upper end of a scale of colours.
template <typename Member>
TuningValue top(std::string_view key, const char* label, std::string_view help, double most, const char* suffix,
                Member member) {
  return number({.key = key,
                 .label = label,
                 .help = help,
                 .least = 0.1,
                 .most = most,
                 .track = {.decimals = 1, .logarithmic = true, .suffix = suffix}},
                member);
}

}  // namespace

std::vector<TuningValue> view_values() {
  return {
      word({.key = "debug_view",
            .label = "Colours",
            .option = "--colours NAME",
            .help = "Colours over the characters: {values} ({default})"},
           at(&Tuning::debug_view), debug_view_words),
      top("top_speed", "Speed up to", "Metres a second that the last colour stands for, {values} ({default})", 20,
          " m/s", at(&Tuning::top_speed)),
      top("top_density", "Density up to", "People a square metre that the last colour stands for, {values} ({default})",
          50, " /m\xC2\xB2", at(&Tuning::top_density)),
      top("top_presence", "Presence up to", "Seconds that the last colour stands for, {values} ({default})", 36'000,
          " s", at(&Tuning::top_presence)),
      number({.key = "density_cut_off",
              .label = "Cut-off",
              .help = "Metres that a person's own ground reaches at most, for the density, {values} ({default})",
              .least = 0.1,
              .most = 10,
              .track = {.least = 0.1, .most = 3, .decimals = 2, .suffix = " m"}},
             at(&Tuning::density_cut_off)),
      number({.key = "trail_seconds",
              .label = "Trails",
              .option = "--trails SECONDS",
              .help = "The way that people of a file went in the last seconds is drawn, {values} ({default})",
              .most = 30,
              .track = {.decimals = 1, .zero_word = "off", .suffix = " s"}},
             at(&Tuning::trail_seconds)),
      on_off({.key = "plain_bodies",
              .label = "Plain bodies",
              .option = "--plain-bodies on|off",
              .help = "Bodies are grey, without clothes' colours and textures, where --colours gives them no colour"
                      " ({default})"},
             at(&Tuning::plain_bodies)),
      on_off({.key = "ids",
              .label = "Ids",
              .option = "--ids on|off",
              .help = "The ids that people have in their file, or else the numbers of agents, stand above heads"
                      " ({default})"},
             at(&Tuning::ids)),
      number({.key = "picture_size",
              .label = "Picture size",
              .option = "--picture-size PERCENT",
              .help = "Per cent of a window's width and height that the crowd is drawn in, {values} ({default}); it is"
                      " then stretched smoothly, and the panel stays sharp",
              .least = 25,
              .most = 100,
              .track = {.suffix = " %"}},
             at(&Tuning::picture_size)),
      on_off(
          {.key = "holds_rate",
           .label = "Hold frame rate",
           .help = "A window gives up shadows, triangles and picture size to show so many frames a second ({default})",
           .device_decides = true},
          at(&Tuning::holds_rate)),
      number({.key = "frame_rate",
              .label = "Frame rate",
              .option = "--frame-rate X",
              .help = "Frames a second that a window holds, {values} ({default}; 60 where a card draws)",
              .least = 5,
              .most = 240,
              .device_decides = true,
              .track = {.suffix = " /s"}},
             at(&Tuning::frame_rate)),
      number({.key = "frame_limit",
              .label = "Frame limit",
              .help = "Frames a second that a window shows at most, {values} ({default}); 0: no limit",
              .most = 240,
              .track = {.zero_word = "off", .suffix = " /s"}},
             at(&Tuning::frame_limit)),
      on_off({.key = "vertical_sync",
              .label = "Vertical sync",
              .help = "A window shows a frame when the display is refreshed, so that no picture is torn ({default})"},
             at(&Tuning::vertical_sync)),
      on_off({.key = "bones_as_lines",
              .label = "Bones as lines",
              .help = "Skeletons are drawn over the characters ({default})"},
             at(&Tuning::bones_as_lines)),
  };
}

}  // namespace throng::app
