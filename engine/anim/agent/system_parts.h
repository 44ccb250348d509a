#pragma once

#include <atomic>

#include "engine/anim/agent/exact_poser.h"
#include "engine/anim/agent/fitted_scheduler.h"
#include "engine/anim/agent/frame_work.h"
#include "engine/anim/agent/population.h"

namespace throng::anim {

/// The inside of an AnimationSystem. The system, its characters, its agents and its figures work on it.
struct SystemParts {
  Population population;
  FittedScheduler pus;
  FrameWork frame;
  ExactPoser exact;
  std::atomic<bool> turn{false};  ///< some call changes the system; see Turn
};

}  // namespace throng::anim
