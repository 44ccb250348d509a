#include <cstddef>
#include <span>

#include "engine/anim/api/c/parts.h"

using namespace throng::c;

namespace {

/// Returns structs of C as those of C++, which have the same layout.
template <typename Cpp, typename C>
std::span<Cpp> as(C* structs, uint32_t count) {
  static_assert(sizeof(Cpp) == sizeof(C));
  static_assert(alignof(Cpp) == alignof(C));
  return {reinterpret_cast<Cpp*>(structs), count};
}

static_assert(offsetof(SpeedRequest, speed) == offsetof(throng_speed_request, speed));
static_assert(offsetof(ParameterRequest, channel) == offsetof(throng_parameter_request, channel));
static_assert(offsetof(ParameterRequest, y) == offsetof(throng_parameter_request, y));
static_assert(offsetof(RootMotion, turn) == offsetof(throng_root_motion, turn));

}  // namespace

int throng_crowd_set_speeds(throng_crowd* crowd, const throng_speed_request* requests, uint32_t count) {
  const Call call("throng_crowd_set_speeds");
  if (call.is_missing(crowd, requests)) return failed;
  return call.outcome(crowd->own.many().set_speeds(as<const SpeedRequest>(requests, count)));
}

int throng_crowd_set_parameters(throng_crowd* crowd, const throng_parameter_request* requests, uint32_t count) {
  const Call call("throng_crowd_set_parameters");
  if (call.is_missing(crowd, requests)) return failed;
  return call.outcome(crowd->own.many().set_parameters(as<const ParameterRequest>(requests, count)));
}

int throng_crowd_look_at(throng_crowd* crowd, const throng_gaze_request* requests, uint32_t count) {
  const Call call("throng_crowd_look_at");
  if (call.is_missing(crowd, requests)) return failed;
  crowd->gazes.clear();
  for (const throng_gaze_request& request : std::span(requests, count)) {
    crowd->gazes.push_back({.agent = agent_id(request.agent),
                            .gaze = {request.process},
                            .target = vector_of(request.target),
                            .fade = to_ticks(static_cast<double>(request.fade))});
  }
  return call.outcome(crowd->own.many().look_at(crowd->gazes));
}

int throng_crowd_displacements(const throng_crowd* crowd, double from, double to, const throng_id* agents,
                               uint32_t count, throng_root_motion* motions) {
  const Call call("throng_crowd_displacements");
  if (call.is_missing(crowd, agents, motions)) return failed;
  const ManyAgents many(crowd->own.parts());
  return call.outcome(many.displacements(to_ticks(from), to_ticks(to), as<const AgentId>(agents, count),
                                         as<RootMotion>(motions, count)));
}
