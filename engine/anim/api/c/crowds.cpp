#include <algorithm>

#include "engine/anim/api/c/parts.h"

using namespace throng::c;  // NOLINT: functions of C have no namespace

throng_crowd* throng_crowd_create(const throng_character* character, uint32_t pus, uint32_t hashes) {
  if (is_missing("throng_crowd_create", character)) return nullptr;
  constexpr std::uint32_t too_many = 1'000'000;  // more would not fit the option
  Result<Crowd> made =
      Crowd::create(character->own, {.pus = static_cast<int>(std::min(pus, too_many)), .hash = hashes != 0});
  if (made) return make<throng_crowd>(std::move(*made));
  fail(made.error().message);
  return nullptr;
}

void throng_crowd_free(throng_crowd* crowd) { delete crowd; }

throng_id throng_crowd_add_character(throng_crowd* crowd, const throng_character* character) {
  if (is_missing("throng_crowd_add_character", crowd, character)) return id_of(CharacterId{});
  const Result<CharacterId> id = crowd->own.add(character->own);
  if (!id) fail(id.error().message);
  return id_of(id ? *id : CharacterId{});
}

int throng_crowd_remove_character(throng_crowd* crowd, throng_id character) {
  if (is_missing("throng_crowd_remove_character", crowd)) return failed;
  return outcome(crowd->own.remove(character_id(character)));
}

uint32_t throng_crowd_palette_bytes(const throng_crowd* crowd, throng_id character) {
  if (is_missing("throng_crowd_palette_bytes", crowd)) return 0;
  return static_cast<uint32_t>(crowd->own.palette_bytes(character_id(character)));
}

int throng_crowd_add_agents(throng_crowd* crowd, throng_id character, uint32_t count, throng_id* agents) {
  const Call call("throng_crowd_add_agents");
  if (call.is_missing(crowd, agents)) return failed;
  const std::span<const AgentId> added = crowd->own.add_agents(count, character_id(character));
  for (std::size_t i = 0; i < added.size(); ++i) agents[i] = id_of(added[i]);
  return call.outcome(added.size() == count);
}

int throng_crowd_remove_agent(throng_crowd* crowd, throng_id agent) {
  const Call call("throng_crowd_remove_agent");
  return call.is_missing(crowd) ? failed : call.outcome(crowd->own.remove_agent(agent_id(agent)));
}

uint32_t throng_crowd_agent_count(const throng_crowd* crowd) {
  return is_missing("throng_crowd_agent_count", crowd) ? 0 : static_cast<uint32_t>(crowd->own.agents().size());
}

int throng_crowd_advance(throng_crowd* crowd, double seconds) {
  const Call call("throng_crowd_advance");
  if (call.is_missing(crowd)) return failed;
  crowd->own.advance(to_ticks(seconds));
  return call.outcome();
}

double throng_crowd_clock(const throng_crowd* crowd) {
  return is_missing("throng_crowd_clock", crowd) ? 0.0 : to_seconds(crowd->own.clock());
}

int throng_crowd_update(throng_crowd* crowd, const throng_pose_request* requests, uint32_t count) {
  const Call call("throng_crowd_update");
  if (call.is_missing(crowd) || (count > 0 && call.is_missing(requests))) return failed;
  crowd->requests.clear();
  for (std::uint32_t i = 0; i < count; ++i) {
    crowd->requests.push_back({.agent = agent_id(requests[i].agent),
                               .level = static_cast<std::uint8_t>(std::min(requests[i].level, std::uint32_t{255})),
                               .palette = reinterpret_cast<std::byte*>(requests[i].palette)});
  }
  crowd->own.update(crowd->requests);
  return call.outcome();
}

int throng_crowd_update_all(throng_crowd* crowd, float* palettes, size_t bytes, uint32_t stride) {
  const Call call("throng_crowd_update_all");
  if (call.is_missing(crowd, palettes)) return failed;
  auto* const memory = reinterpret_cast<std::byte*>(palettes);
  crowd->requests.clear();
  for (const AgentId agent : crowd->own.agents()) {
    const Agent own = crowd->own.agent(agent);
    const std::size_t needed = crowd->own.palette_bytes(own.character());
    if (stride < needed || bytes / stride <= agent.number) {
      return fail("throng_crowd_update_all: there is no room for the palette of agent " + std::to_string(agent.number));
    }
    crowd->requests.push_back({.agent = agent, .palette = memory + std::size_t{agent.number} * stride});
  }
  crowd->own.update(crowd->requests);
  return call.outcome();
}

uint64_t throng_crowd_pose_hash(const throng_crowd* crowd) {
  return is_missing("throng_crowd_pose_hash", crowd) ? 0 : crowd->own.debug().pose_hash();
}

int throng_agent_play(throng_crowd* crowd, throng_id agent, const throng_play* play) {
  const Call call("throng_agent_play");
  if (call.is_missing(crowd, play)) return failed;
  return call.outcome(agent_of(crowd, agent)
                          .play({.clip = {play->clip},
                                 .fade = to_ticks(static_cast<double>(play->fade)),
                                 .speed = static_cast<double>(play->speed),
                                 .start = to_ticks(static_cast<double>(play->start)),
                                 .loop = play->loop != 0}));
}

int throng_agent_set_speed(throng_crowd* crowd, throng_id agent, float speed) {
  const Call call("throng_agent_set_speed");
  if (call.is_missing(crowd)) return failed;
  return call.outcome(agent_of(crowd, agent).set_speed(static_cast<double>(speed)));
}

uint32_t throng_agent_add_blend_space(throng_crowd* crowd, throng_id agent, const uint32_t* clips,
                                      const float* parameters, uint32_t count, uint32_t is_ground_speed) {
  if (is_missing("throng_agent_add_blend_space", crowd, clips, parameters)) return THRONG_NONE;
  std::vector<BlendPoint> points;
  for (std::uint32_t i = 0; i < count; ++i) points.push_back({.clip = {clips[i]}, .parameter = parameters[i]});
  return number_or_none(agent_of(crowd, agent)
                            .add(BlendSpace{.points = points,
                                            .parameter = count > 0 ? parameters[0] : 0.0F,
                                            .is_ground_speed = is_ground_speed != 0}));
}

int throng_agent_set_parameter(throng_crowd* crowd, throng_id agent, uint32_t channel, float parameter) {
  const Call call("throng_agent_set_parameter");
  if (call.is_missing(crowd)) return failed;
  return call.outcome(agent_of(crowd, agent).set_parameter({channel}, parameter));
}

uint32_t throng_agent_add_look_at(throng_crowd* crowd, throng_id agent) {
  if (is_missing("throng_agent_add_look_at", crowd)) return THRONG_NONE;
  return number_or_none(agent_of(crowd, agent).add(LookAt{}));
}

int throng_agent_look_at(throng_crowd* crowd, throng_id agent, uint32_t process, const float target[3], float fade) {
  const Call call("throng_agent_look_at");
  if (call.is_missing(crowd, target)) return failed;
  const Ticks time = to_ticks(static_cast<double>(fade));
  return call.outcome(agent_of(crowd, agent).processes().look_at({process}, vector_of(target), time));
}

uint32_t throng_agent_add_reach(throng_crowd* crowd, throng_id agent, uint32_t limb) {
  if (is_missing("throng_agent_add_reach", crowd)) return THRONG_NONE;
  if (limb <= static_cast<std::uint32_t>(Limb::right_leg)) {
    return number_or_none(agent_of(crowd, agent).add(Reach{.limb = static_cast<Limb>(limb)}));
  }
  fail("throng_agent_add_reach: a limb is from 0 to 3");
  return THRONG_NONE;
}

int throng_agent_reach(throng_crowd* crowd, throng_id agent, uint32_t process, const float target[3], float weight,
                       float fade) {
  const Call call("throng_agent_reach");
  if (call.is_missing(crowd, target)) return failed;
  const Processes processes = agent_of(crowd, agent).processes();
  const bool reaches = processes.reach({process}, vector_of(target));
  return call.outcome(reaches && processes.set_weight({process}, weight, to_ticks(static_cast<double>(fade))));
}

uint32_t throng_agent_add_socket(throng_crowd* crowd, throng_id agent, uint32_t bone) {
  if (is_missing("throng_agent_add_socket", crowd)) return THRONG_NONE;
  return number_or_none(agent_of(crowd, agent).add(Socket{.bone = static_cast<int>(bone)}));
}

int throng_agent_socket(const throng_crowd* crowd, throng_id agent, uint32_t process, float position[3],
                        float rotation[4]) {
  const Call call("throng_agent_socket");
  if (call.is_missing(crowd, position, rotation)) return failed;
  const Place place = agent_of(crowd, agent).processes().socket({process});
  write(place.position, position);
  rotation[0] = place.rotation.x;
  rotation[1] = place.rotation.y;
  rotation[2] = place.rotation.z;
  rotation[3] = place.rotation.w;
  return call.outcome();
}

int throng_agent_displacement(const throng_crowd* crowd, throng_id agent, double from, double to, float displacement[3],
                              float* turn) {
  const Call call("throng_agent_displacement");
  if (call.is_missing(crowd, displacement, turn)) return failed;
  const RootMotion motion = agent_of(crowd, agent).motion().displacement(to_ticks(from), to_ticks(to));
  write(motion.displacement, displacement);
  *turn = motion.turn;
  return call.outcome();
}

uint32_t throng_agent_keys(const throng_crowd* crowd, throng_id agent, double from, double to, throng_key* keys,
                           uint32_t most) {
  const Call call("throng_agent_keys");
  if (call.is_missing(crowd) || (most > 0 && call.is_missing(keys))) return 0;
  std::uint32_t count = 0;
  agent_of(crowd, agent).motion().for_each_key(to_ticks(from), to_ticks(to), [&](const DataKey& key) {
    if (count < most) {
      keys[count] = {.name = key.name, .clip = key.clip.number, .time = to_seconds(key.time), .weight = key.weight};
    }
    ++count;
  });
  return call.went_well() ? count : 0;
}

throng_snapshot* throng_crowd_snapshot(const throng_crowd* crowd) {
  const Call call("throng_crowd_snapshot");
  if (call.is_missing(crowd)) return nullptr;
  throng_snapshot* const made = make<throng_snapshot>();
  if (made == nullptr) return nullptr;
  crowd->own.snapshot(made->own);
  if (call.went_well()) return made;
  delete made;
  return nullptr;
}

int throng_crowd_restore(throng_crowd* crowd, const throng_snapshot* snapshot) {
  if (is_missing("throng_crowd_restore", crowd, snapshot)) return failed;
  return outcome(crowd->own.restore(snapshot->own));
}

void throng_snapshot_free(throng_snapshot* snapshot) { delete snapshot; }
