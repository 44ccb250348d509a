#pragma once

#include <cstdint>

#include "engine/anim/run/store/trace.h"

namespace throng::anim {

/// The work that one PU did in one update.
struct PuActivity {
  std::uint32_t tasks = 0;
  std::uint32_t agents = 0;
  double busy_ms = 0;
  CopyCounts copies;
};

/// The figures of the last update.
struct UpdateReport {
  std::uint32_t agents_updated = 0;
  std::uint64_t bones_evaluated = 0;
  std::uint64_t palette_bytes = 0;
  double predicted_nanoseconds = 0;  ///< time of one PU, by SystemOptions::cost: agents, and tiles as wide as they come
  CopyCounts copies;
};

}  // namespace throng::anim
