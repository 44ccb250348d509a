#include <array>

#include "tests/api/random_calls.h"

namespace throng::api_test {

void RandomCalls::add_process() {
  const Agent one = agent();
  const std::array<SpringChain, 1> chain{SpringChain{.first = one_in(2) ? "neck" : "upper_arm.L",
                                                     .last = one_in(2) ? "head" : "hand.L",
                                                     .stiffness = number(),
                                                     .damping = number(),
                                                     .gravity = vector(),
                                                     .radius = number(),
                                                     .tip = number()}};
  switch (below(10)) {
    case 0:
      static_cast<void>(one.add(LookAt{number(), number(), number(), number()}));
      return;
    case 1:
      static_cast<void>(one.add(Reach{static_cast<Limb>(below(4)), number(), vector()}));
      return;
    case 2:
      static_cast<void>(one.add(ChainReach{"spine1", one_in(2) ? "head" : "hand.L", index(), number()}));
      return;
    case 3:
      static_cast<void>(one.add(FootPlacement{number(), number()}));
      return;
    case 4:
      static_cast<void>(one.add(Noise{number(), number(), count(), mask()}));
      return;
    case 5:
      if (one_in(4)) static_cast<void>(one.add(Springs{.chains = chain, .colliders = {}}));
      return;
    case 6:
      static_cast<void>(one.add(Ragdoll{time()}));
      return;
    case 7:
      static_cast<void>(one.add(Socket{index(), place()}));
      return;
    case 8:
      if (!steps_.empty()) static_cast<void>(one.add(steps_[below(static_cast<std::uint32_t>(steps_.size()))]));
      static_cast<void>(one.add(StepId{character_id(), count()}));
      return;
    default:
      one.remove(process());
  }
}

void RandomCalls::call_process() {
  const Processes processes = agent().processes();
  switch (below(10)) {
    case 0:
      processes.set_weight(process(), number(), time());
      return;
    case 1:
      processes.look_at(process(), vector(), time());
      return;
    case 2:
      processes.look_away(process(), time());
      return;
    case 3:
      processes.reach(process(), vector());
      return;
    case 4:
      processes.set_placement(process(), place());
      return;
    case 5:
      processes.set_ground(process(), index(), vector(), vector());
      return;
    case 6:
      static_cast<void>(processes.ankle(process(), index()));
      return;
    case 7:
      processes.push(process(), vector(), vector());
      return;
    case 8:
      processes.recover(process(), time());
      return;
    default:
      static_cast<void>(processes.is_down(process()));
      static_cast<void>(processes.socket(process()));
  }
}

}  // namespace throng::api_test
