#include <algorithm>
#include <cstddef>

#include "engine/anim/api/c/motion_parts.h"

using namespace throng::c;

namespace {

static_assert(offsetof(SpeedRequest, speed) == offsetof(throng_speed_request, speed));
static_assert(offsetof(ParameterRequest, channel) == offsetof(throng_parameter_request, channel));
static_assert(offsetof(ParameterRequest, y) == offsetof(throng_parameter_request, y));
static_assert(offsetof(ReachRequest, target) == offsetof(throng_reach_request, target));
static_assert(offsetof(PlacementRequest, model_in_world) == offsetof(throng_placement_request, model_in_world));
static_assert(offsetof(GroundRequest, leg) == offsetof(throng_ground_request, leg));
static_assert(offsetof(GroundRequest, normal) == offsetof(throng_ground_request, normal));
static_assert(offsetof(ProcessOf, process) == offsetof(throng_process_of, process));
static_assert(offsetof(RootMotion, turn) == offsetof(throng_root_motion, turn));

ManyAgents many_of(const throng_crowd* crowd) { return ManyAgents(crowd->own.parts()); }

/// Hands an array of requests to a function of ManyAgents.
template <typename Cpp, typename C>
int hand_on(const char* name, throng_crowd* crowd, const C* requests, uint32_t count,
            bool (ManyAgents::*take)(std::span<const Cpp>) const) {
  const Call call(name);
  if (call.is_missing(crowd) || call.lacks(requests, count)) return failed;
  return call.outcome((many_of(crowd).*take)(as<const Cpp>(requests, count)));
}

}  // namespace

int throng_crowd_set_speeds(throng_crowd* crowd, const throng_speed_request* requests, uint32_t count) {
  return hand_on("throng_crowd_set_speeds", crowd, requests, count, &ManyAgents::set_speeds);
}

int throng_crowd_set_parameters(throng_crowd* crowd, const throng_parameter_request* requests, uint32_t count) {
  return hand_on("throng_crowd_set_parameters", crowd, requests, count, &ManyAgents::set_parameters);
}

int throng_crowd_look_at(throng_crowd* crowd, const throng_gaze_request* requests, uint32_t count) {
  const Call call("throng_crowd_look_at");
  if (call.is_missing(crowd) || call.lacks(requests, count)) return failed;
  crowd->gazes.clear();
  for (const throng_gaze_request& request : std::span(requests, count)) {
    crowd->gazes.push_back({.agent = agent_id(request.agent),
                            .gaze = {request.process},
                            .target = vector_of(request.target),
                            .fade = ticks_of(request.fade)});
  }
  return call.outcome(many_of(crowd).look_at(crowd->gazes));
}

int throng_crowd_reach(throng_crowd* crowd, const throng_reach_request* requests, uint32_t count) {
  return hand_on("throng_crowd_reach", crowd, requests, count, &ManyAgents::reach);
}

int throng_crowd_set_placements(throng_crowd* crowd, const throng_placement_request* requests, uint32_t count) {
  return hand_on("throng_crowd_set_placements", crowd, requests, count, &ManyAgents::set_placements);
}

int throng_crowd_set_grounds(throng_crowd* crowd, const throng_ground_request* requests, uint32_t count) {
  return hand_on("throng_crowd_set_grounds", crowd, requests, count, &ManyAgents::set_grounds);
}

int throng_crowd_displacements(const throng_crowd* crowd, double from, double to, const throng_id* agents,
                               uint32_t count, throng_root_motion* motions) {
  const Call call("throng_crowd_displacements");
  if (call.is_missing(crowd) || call.lacks(agents, count) || call.lacks(motions, count)) return failed;
  return call.outcome(many_of(crowd).displacements(ticks_of(from), ticks_of(to), as<const AgentId>(agents, count),
                                                   as<RootMotion>(motions, count)));
}

uint32_t throng_crowd_keys(const throng_crowd* crowd, double from, double to, const throng_id* agents, uint32_t count,
                           uint32_t choice, throng_agent_key* keys, uint32_t most) {
  const Call call("throng_crowd_keys");
  if (call.is_missing(crowd) || call.lacks(agents, count) || call.lacks(keys, most) || !is_choice(call, choice))
    return 0;
  const std::span<const AgentKey> met = many_of(crowd).keys(
      ticks_of(from), ticks_of(to), as<const AgentId>(agents, count), static_cast<KeyChoice>(choice));
  std::ranges::transform(met.first(std::min<std::size_t>(met.size(), most)), keys, [](const AgentKey& one) {
    return throng_agent_key{.agent = id_of(one.agent), .key = c_key_of(one.key)};
  });
  return call.answer(static_cast<uint32_t>(met.size()));
}

int throng_crowd_sockets(const throng_crowd* crowd, const throng_process_of* sockets, uint32_t count,
                         throng_place* places) {
  const Call call("throng_crowd_sockets");
  if (call.is_missing(crowd) || call.lacks(sockets, count) || call.lacks(places, count)) return failed;
  return call.outcome(many_of(crowd).sockets(as<const ProcessOf>(sockets, count), as<Place>(places, count)));
}
