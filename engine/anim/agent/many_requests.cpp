#include "engine/anim/agent/many_requests.h"

#include <atomic>
#include <type_traits>
#include <utility>

#include "engine/anim/agent/blend_space_2d_channel.h"
#include "engine/anim/agent/blend_space_channel.h"
#include "engine/anim/agent/foot_placement_process.h"
#include "engine/anim/agent/spring_bones_process.h"
#include "engine/anim/agent/targeted_processes.h"
#include "engine/anim/base/finite.h"
#include "engine/anim/kernel/limb/joint_place.h"
#include "engine/base/glm_numbers.h"

namespace throng::anim {
namespace {

constexpr const char* no_such_part = "the agent has no channel or process of this id that can do so";

template <typename Own>
bool has(const Agent& agent, ChannelId channel) {
  return agent.channel<Own>(channel) != nullptr;
}
template <typename Own>
bool has(const Agent& agent, ProcessId process) {
  return agent.post_process<Own>(process) != nullptr;
}

template <typename Own, typename Set>
bool change(Agent& agent, ChannelId channel, const Set& set, const char* call) {
  return agent.change<Own>(channel, set, call).has_value();
}
template <typename Own, typename Set>
bool change(Agent& agent, ProcessId process, const Set& set, const char* call) {
  return agent.change_process<Own>(process, set, call).has_value();
}

Footing footing_of(const GroundRequest& request) {
  return {.place = to_glm(request.point), .normal = to_glm(request.normal)};
}

}  // namespace

template <typename Request, typename TakeInPlace, typename TakeAlone>
bool ManyRequests::take(std::span<const Request> requests, const char* call, const TakeInPlace& in_place,
                        const TakeAlone& alone) const {
  const Zone zone(call, 0);
  ManyScratch& scratch = system_->many;
  const char* fault = nullptr;
  {
    const Turn turn(system_->turn, call);
    if (!turn) return false;
    scratch.calls.resize(system_->population.numbers().number_limit());
    scratch.waits.assign(requests.size(), 0);
    ++scratch.call;
    const auto goes_on = [&](std::size_t i) { return i > 0 && requests[i].agent == requests[i - 1].agent; };
    for (std::size_t i = 0; i < requests.size(); ++i) {
      const std::uint32_t agent = requests[i].agent.number;
      if (agent >= scratch.calls.size()) continue;
      const bool is_named_before = std::exchange(scratch.calls[agent], scratch.call) == scratch.call;
      scratch.waits[i] = goes_on(i) ? scratch.waits[i - 1] : (is_named_before ? 1 : 0);
    }
    std::atomic<const char*> some_fault{nullptr};
    const auto take_one = [&](const Agent& agent, std::size_t i) {
      const Outcome outcome = agent.exists() ? in_place(agent, requests[i]) : Outcome{.fault = no_agent};
      if (outcome.fault != nullptr) some_fault.store(outcome.fault, std::memory_order_relaxed);
      return outcome.waits;
    };
    // The first of the requests that name an agent one after the other takes the others with it.
    const auto take_run = [&](std::size_t first) {
      if (goes_on(first) || scratch.waits[first] != 0) return;
      const Agent agent(*system_, requests[first].agent);
      bool waits = false;
      for (std::size_t i = first; i == first || (i < requests.size() && goes_on(i)); ++i) {
        waits = waits || take_one(agent, i);
        scratch.waits[i] = waits ? 1 : 0;
      }
    };
    read(call, requests.size(), take_run);
    fault = some_fault.load();
  }
  bool all = true;
  for (std::size_t i = 0; i < requests.size(); ++i) {
    if (scratch.waits[i] == 0) continue;
    Agent agent(*system_, requests[i].agent);
    all = alone(agent, requests[i]) && all;
  }
  return fault == nullptr ? all : report_misuse({call, fault});
}

/// Takes requests to a channel or process of one of these types.
template <typename... Parts, typename Request, typename Part, typename FaultOf, typename Set>
bool ManyRequests::take_parts(std::span<const Request> requests, const char* call, Part Request::*part,
                              const FaultOf& fault_of, const Set& set) const {
  const auto in_place = [&](const Agent& agent, const Request& request) -> Outcome {
    if (const char* const fault = fault_of(request); fault != nullptr) return {.fault = fault};
    Agent::Changed changed = Agent::Changed::no_such_part;
    const auto change_one = [&]<typename Own>(std::type_identity<Own>) {
      changed = agent.change_in_place<Own>(request.*part, [&](Own& own) { set(own, request); });
      return changed != Agent::Changed::no_such_part;
    };
    const bool has_it = (change_one(std::type_identity<Parts>()) || ...);
    return {.fault = has_it ? nullptr : no_such_part, .waits = changed == Agent::Changed::needs_entities};
  };
  const auto alone = [&](Agent& agent, const Request& request) {
    if (const char* const fault = fault_of(request); fault != nullptr) return report_misuse({call, fault});
    bool done = false;
    const auto change_one = [&]<typename Own>(std::type_identity<Own>) {
      if (!has<Own>(agent, request.*part)) return false;
      done = change<Own>(
          agent, request.*part, [&](Own& own) { set(own, request); }, call);
      return true;
    };
    const bool has_it = (change_one(std::type_identity<Parts>()) || ...);
    return has_it ? done : report_misuse({call, no_such_part});
  };
  return take(requests, call, in_place, alone);
}

bool ManyRequests::set_speeds(std::span<const SpeedRequest> requests, const char* call) const {
  const auto in_place = [](const Agent& agent, const SpeedRequest& request) -> Outcome {
    return {.fault = agent.try_set_speed(static_cast<double>(request.speed))};
  };
  const auto alone = [](Agent& agent, const SpeedRequest& request) {
    return agent.set_speed(static_cast<double>(request.speed));
  };
  return take(requests, call, in_place, alone);
}

bool ManyRequests::set_parameters(std::span<const ParameterRequest> requests, const char* call) const {
  struct Set {
    void operator()(BlendSpaceChannel& space, const ParameterRequest& request) const { space.set_parameter(request.x); }
    void operator()(BlendSpace2dChannel& space, const ParameterRequest& request) const {
      space.set_place({request.x, request.y});
    }
  };
  return take_parts<BlendSpaceChannel, BlendSpace2dChannel>(
      requests, call, &ParameterRequest::channel,
      [](const ParameterRequest& request) -> const char* {
        return all_finite(glm::vec2(request.x, request.y)) ? nullptr : "parameters are finite numbers";
      },
      Set{});
}

bool ManyRequests::look_at(std::span<const GazeRequest> requests, const char* call) const {
  return take_parts<LookAtProcess>(
      requests, call, &GazeRequest::gaze,
      [](const GazeRequest& request) -> const char* {
        if (!is_fade(request.fade)) return not_a_fade;
        return all_finite(to_glm(request.target)) ? nullptr : "a target is of finite numbers";
      },
      [](LookAtProcess& gaze, const GazeRequest& request) { gaze.look_at(to_glm(request.target), request.fade); });
}

bool ManyRequests::reach(std::span<const ReachRequest> requests, const char* call) const {
  return take_parts<ReachProcess, ChainReachProcess>(
      requests, call, &ReachRequest::limb,
      [](const ReachRequest& request) -> const char* {
        return all_finite(to_glm(request.target)) ? nullptr : "a target is of finite numbers";
      },
      [](auto& limb, const ReachRequest& request) { limb.set_target(to_glm(request.target)); });
}

bool ManyRequests::set_placements(std::span<const PlacementRequest> requests, const char* call) const {
  return take_parts<FootPlacementProcess, SpringBonesProcess>(
      requests, call, &PlacementRequest::process,
      [](const PlacementRequest& request) -> const char* {
        return is_valid(to_joint(request.model_in_world)) ? nullptr : not_a_placement;
      },
      [](auto& process, const PlacementRequest& request) { process.set_placement(to_joint(request.model_in_world)); });
}

bool ManyRequests::set_grounds(std::span<const GroundRequest> requests, const char* call) const {
  return take_parts<FootPlacementProcess>(
      requests, call, &GroundRequest::feet,
      [](const GroundRequest& request) -> const char* {
        const bool is_leg = request.leg >= -1 && request.leg < max_legs;
        return is_leg && is_valid(footing_of(request)) ? nullptr : not_a_ground;
      },
      [](FootPlacementProcess& feet, const GroundRequest& request) {
        if (request.leg == -1) feet.set_ground(footing_of(request));
        if (request.leg != -1) feet.set_ground(request.leg, footing_of(request));
      });
}

}  // namespace throng::anim
