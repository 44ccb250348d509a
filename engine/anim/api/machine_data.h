#pragma once

#include <memory>
#include <string>
#include <vector>

#include "throng/ids.h"

#include "engine/anim/agent/channel/state_machine.h"

namespace throng::detail {

/// The inside of a StateMachine.
struct MachineData {
  std::shared_ptr<const anim::StateMachine> machine;
  std::vector<ClipId> clips;       // that its states play
  std::vector<std::string> names;  // of these clips
};

}  // namespace throng::detail
