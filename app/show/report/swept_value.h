#pragma once

#include <array>
#include <cstdint>

#include "app/settings/settings.h"

namespace throng::app {

/// The value of the tuning that a sweep goes through, and its unit there.
enum class SweptValue : std::uint8_t {
  pus,          ///< threads
  local_store,  ///< KiB
  tile,         ///< characters
  grain,        ///< microseconds
};

/// The values at which a sweep stops. Sliders stop there too.
inline constexpr std::array local_store_stops = {16, 32, 64, 128, 256, 512, 1024};
inline constexpr std::array tile_stops = {1, 2, 4, 8, 16};
inline constexpr std::array grain_stops = {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000};

double swept_value(SweptValue value, const Tuning& tuning);
void set_swept_value(SweptValue value, double to, Tuning& tuning);

}  // namespace throng::app
