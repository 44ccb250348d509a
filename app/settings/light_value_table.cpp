#include "app/settings/tuning_value_kinds.h"
#include "app/settings/tuning_value_table.h"

namespace throng::app {

using render::SceneLight;

std::vector<TuningValue> light_values() {
  const auto degrees = [](std::string_view key, const char* label, std::string_view help, double least, double most) {
    return TuningValue{
        .key = key, .label = label, .help = help, .least = least, .most = most, .track = {.suffix = "\xC2\xB0"}};
  };
  return {
      number(degrees("sun_elevation", "Sun above horizon",
                     "Degrees of the sun above the horizon, {values} ({default}); from -6 it is night", -90, 90),
             at(&Tuning::light, &SceneLight::sun_elevation)),
      number(
          degrees("sun_azimuth", "Sun towards", "Degrees of the sun from +Z towards +X, {values} ({default})", 0, 360),
          at(&Tuning::light, &SceneLight::sun_azimuth)),
      number({.key = "clouds",
              .label = "Clouds",
              .option = "--clouds X",
              .help = "The share of the sky that clouds cover: {values} ({default}); at 1 the sun is behind them",
              .most = 1,
              .track = {.decimals = 2}},
             at(&Tuning::light, &SceneLight::clouds)),
      number({.key = "exposure",
              .label = "Exposure",
              .option = "--exposure STOPS",
              .help = "How much brighter than what suits the light, in stops: {values} ({default})",
              .least = -8,
              .most = 8,
              .track = {.least = -3, .most = 3, .decimals = 2, .suffix = " stops"}},
             at(&Tuning::light, &SceneLight::exposure)),
      on_off({.key = "shadows",
              .label = "Shadows",
              .option = "--shadows on|off",
              .help = "People and things cast shadows ({default})",
              .device_decides = true},
             at(&Tuning::shadows)),
      on_off({.key = "crowd_shade",
              .label = "Crowd shade",
              .option = "--crowd-shade on|off",
              .help = "Bodies darken each other and the ground between them, where they hide the sky ({default})",
              .device_decides = true},
             at(&Tuning::crowd_shade)),
  };
}

}  // namespace throng::app
