#include "engine/anim/api/c/parts.h"

namespace throng::c {
namespace {

Processes processes_of(const throng_crowd* crowd, throng_id agent) { return agent_of(crowd, agent).processes(); }

}  // namespace
}  // namespace throng::c

using namespace throng::c;  // NOLINT: functions of C have no namespace

int throng_agent_remove_process(throng_crowd* crowd, throng_id agent, uint32_t process) {
  const Call call("throng_agent_remove_process");
  return call.is_missing(crowd) ? failed : call.outcome(agent_of(crowd, agent).remove(ProcessId{process}));
}

int throng_agent_set_process_weight(throng_crowd* crowd, throng_id agent, uint32_t process, float weight, float fade) {
  const Call call("throng_agent_set_process_weight");
  if (call.is_missing(crowd)) return failed;
  return call.outcome(processes_of(crowd, agent).set_weight({process}, weight, ticks_of(fade)));
}

int throng_agent_look_at(throng_crowd* crowd, throng_id agent, uint32_t process, const float target[3], float fade) {
  const Call call("throng_agent_look_at");
  if (call.is_missing(crowd, target)) return failed;
  return call.outcome(processes_of(crowd, agent).look_at({process}, vector_of(target), ticks_of(fade)));
}

int throng_agent_look_away(throng_crowd* crowd, throng_id agent, uint32_t process, float fade) {
  const Call call("throng_agent_look_away");
  if (call.is_missing(crowd)) return failed;
  return call.outcome(processes_of(crowd, agent).look_away({process}, ticks_of(fade)));
}

int throng_agent_reach(throng_crowd* crowd, throng_id agent, uint32_t process, const float target[3], float weight,
                       float fade) {
  const Call call("throng_agent_reach");
  if (call.is_missing(crowd, target)) return failed;
  const Processes processes = processes_of(crowd, agent);
  const bool reaches = processes.reach({process}, vector_of(target));
  return call.outcome(reaches && processes.set_weight({process}, weight, ticks_of(fade)));
}

int throng_agent_set_placement(throng_crowd* crowd, throng_id agent, uint32_t process,
                               const throng_place* model_in_world) {
  const Call call("throng_agent_set_placement");
  if (call.is_missing(crowd, model_in_world)) return failed;
  return call.outcome(processes_of(crowd, agent).set_placement({process}, place_of(*model_in_world)));
}

int throng_agent_set_ground(throng_crowd* crowd, throng_id agent, uint32_t process, uint32_t leg, const float point[3],
                            const float normal[3]) {
  const Call call("throng_agent_set_ground");
  if (call.is_missing(crowd, point, normal)) return failed;
  const auto own_leg = static_cast<int>(leg);  // THRONG_NONE becomes -1
  return call.outcome(processes_of(crowd, agent).set_ground({process}, own_leg, vector_of(point), vector_of(normal)));
}

int throng_agent_ankle(const throng_crowd* crowd, throng_id agent, uint32_t process, uint32_t leg, float ankle[3]) {
  const Call call("throng_agent_ankle");
  if (call.is_missing(crowd, ankle)) return failed;
  write(processes_of(crowd, agent).ankle({process}, static_cast<int>(leg)), ankle);
  return call.outcome();
}

int throng_agent_push(throng_crowd* crowd, throng_id agent, uint32_t process, const float impulse[3],
                      const float place[3]) {
  const Call call("throng_agent_push");
  if (call.is_missing(crowd, impulse, place)) return failed;
  return call.outcome(processes_of(crowd, agent).push({process}, vector_of(impulse), vector_of(place)));
}

int throng_agent_recover(throng_crowd* crowd, throng_id agent, uint32_t process, float fade) {
  const Call call("throng_agent_recover");
  if (call.is_missing(crowd)) return failed;
  return call.outcome(processes_of(crowd, agent).recover({process}, ticks_of(fade)));
}

int throng_agent_is_down(const throng_crowd* crowd, throng_id agent, uint32_t process) {
  const Call call("throng_agent_is_down");
  return call.is_missing(crowd) ? 0 : call.yes_or_no(processes_of(crowd, agent).is_down({process}));
}

int throng_agent_socket(const throng_crowd* crowd, throng_id agent, uint32_t process, throng_place* place) {
  const Call call("throng_agent_socket");
  if (call.is_missing(crowd, place)) return failed;
  *place = c_place_of(processes_of(crowd, agent).socket({process}));
  return call.outcome();
}
