#include "engine/anim/api/c/motion_parts.h"

using namespace throng::c;  // NOLINT: functions of C have no namespace

int throng_agent_displacement(const throng_crowd* crowd, throng_id agent, double from, double to,
                              throng_root_motion* motion) {
  const Call call("throng_agent_displacement");
  if (call.is_missing(crowd, motion)) return failed;
  const RootMotion own = agent_of(crowd, agent).motion().displacement(ticks_of(from), ticks_of(to));
  *motion = std::bit_cast<throng_root_motion>(own);
  return call.outcome();
}

float throng_agent_curve(const throng_crowd* crowd, throng_id agent, uint32_t name) {
  const Call call("throng_agent_curve");
  return call.is_missing(crowd) ? 0.0F : call.answer(agent_of(crowd, agent).motion().curve(name));
}

int throng_agent_morph_weights(const throng_crowd* crowd, throng_id agent, float* weights, uint32_t count) {
  const Call call("throng_agent_morph_weights");
  if (call.is_missing(crowd) || call.lacks(weights, count)) return 0;
  return call.yes_or_no(agent_of(crowd, agent).motion().morph_weights({weights, count}));
}

int throng_agent_absolute_root(const throng_crowd* crowd, throng_id agent, throng_place* place) {
  const Call call("throng_agent_absolute_root");
  if (call.is_missing(crowd, place)) return 0;
  const std::optional<Place> root = agent_of(crowd, agent).motion().absolute_root();
  if (root) *place = c_place_of(*root);
  return call.yes_or_no(root.has_value());
}

uint32_t throng_agent_keys(const throng_crowd* crowd, throng_id agent, double from, double to, uint32_t choice,
                           throng_key* keys, uint32_t most) {
  const Call call("throng_agent_keys");
  if (call.is_missing(crowd) || call.lacks(keys, most) || !is_choice(call, choice)) return 0;
  std::uint32_t count = 0;
  const auto note = [&](const DataKey& key) {
    if (count < most) keys[count] = c_key_of(key);
    ++count;
  };
  agent_of(crowd, agent).motion().for_each_key(ticks_of(from), ticks_of(to), note, static_cast<KeyChoice>(choice));
  return call.answer(count);
}

uint32_t throng_agent_ends(const throng_crowd* crowd, throng_id agent, double from, double to, throng_clip_end* ends,
                           uint32_t most) {
  const Call call("throng_agent_ends");
  if (call.is_missing(crowd) || call.lacks(ends, most)) return 0;
  std::uint32_t count = 0;
  agent_of(crowd, agent).motion().for_each_end(ticks_of(from), ticks_of(to), [&](const ClipEnd& end) {
    if (count < most) ends[count] = {.clip = end.clip.number, .weight = end.weight, .time = to_seconds(end.time)};
    ++count;
  });
  return call.answer(count);
}
