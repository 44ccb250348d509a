#pragma once

#include <memory>

#include "engine/anim/agent/channel/state_machine.h"

namespace throng::detail {

/// The inside of a StateMachine.
struct MachineData {
  std::shared_ptr<const anim::StateMachine> machine;
};

}  // namespace throng::detail
