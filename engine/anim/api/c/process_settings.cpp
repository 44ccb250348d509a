#include <algorithm>
#include <iterator>

#include "engine/anim/api/c/parts.h"

namespace throng::c {

static_assert(THRONG_RIGHT_LEG == static_cast<int>(Limb::right_leg));

template <>
throng_look_at default_of() {
  const LookAt own;
  return {.size = 0,
          .yaw = own.yaw,
          .pitch_up = own.pitch_up,
          .pitch_down = own.pitch_down,
          .smooth_seconds = own.smooth_seconds};
}

template <>
throng_reach default_of() {
  const Reach own;
  throng_reach reach{};
  reach.limb = static_cast<uint32_t>(own.limb);
  reach.softness = own.softness;
  write(own.pole, reach.pole);
  return reach;
}

template <>
throng_chain_reach default_of() {
  const ChainReach own;
  throng_chain_reach reach{};
  reach.iterations = static_cast<uint32_t>(own.iterations);
  reach.tolerance = own.tolerance;
  return reach;
}

template <>
throng_foot_placement default_of() {
  const FootPlacement own;
  return {.size = 0, .max_drop = own.max_drop, .farthest_lock = own.farthest_lock};
}

template <>
throng_noise default_of() {
  const Noise own;
  return {.size = 0, .frequency = own.frequency, .amplitude = own.amplitude, .seed = own.seed, .mask = own.mask.number};
}

template <>
throng_spring_chain default_of() {
  const SpringChain own;
  throng_spring_chain chain{};
  chain.stiffness = own.stiffness;
  chain.damping = own.damping;
  chain.drag = own.drag;
  write(own.gravity, chain.gravity);
  chain.radius = own.radius;
  chain.tip = own.tip;
  return chain;
}

template <>
throng_spring_collider default_of() {
  const SpringCollider own;
  throng_spring_collider collider{};
  collider.radius = own.radius;
  return collider;
}

template <>
throng_springs default_of() {
  return {};
}

template <>
throng_ragdoll default_of() {
  return {.size = 0, .fade = static_cast<float>(to_seconds(Ragdoll{}.fade))};
}

template <>
throng_socket default_of() {
  const Socket own;
  return {.size = 0, .bone = static_cast<uint32_t>(own.bone), .offset = c_place_of(own.offset)};
}

namespace {

SpringChain chain_of(const throng_spring_chain& chain) {
  return {.first = view_of(chain.first),
          .last = view_of(chain.last),
          .stiffness = chain.stiffness,
          .damping = chain.damping,
          .drag = chain.drag,
          .gravity = vector_of(chain.gravity),
          .radius = chain.radius,
          .tip = chain.tip};
}

SpringCollider collider_of(const throng_spring_collider& collider) {
  return {.bone = view_of(collider.bone),
          .from = vector_of(collider.from),
          .to = vector_of(collider.to),
          .radius = collider.radius};
}

/// Calls add(agent, settings) if the settings can be read, and returns the process.
template <typename C, typename Add>
uint32_t add_process(const Call& call, const char* name, throng_crowd* crowd, throng_id agent, const C* settings,
                     const Add& add) {
  if (call.is_missing(crowd)) return THRONG_NONE;
  const auto read = call.read(name, settings);
  return read ? number_or_none(add(agent_of(crowd, agent), *read)) : THRONG_NONE;
}

}  // namespace
}  // namespace throng::c

using namespace throng::c;  // NOLINT: functions of C have no namespace

int throng_look_at_fill(throng_look_at* into, size_t size) { return fill("throng_look_at_fill", into, size); }
int throng_reach_fill(throng_reach* into, size_t size) { return fill("throng_reach_fill", into, size); }
int throng_chain_reach_fill(throng_chain_reach* into, size_t size) {
  return fill("throng_chain_reach_fill", into, size);
}
int throng_foot_placement_fill(throng_foot_placement* into, size_t size) {
  return fill("throng_foot_placement_fill", into, size);
}
int throng_noise_fill(throng_noise* into, size_t size) { return fill("throng_noise_fill", into, size); }
int throng_spring_chain_fill(throng_spring_chain* into, size_t size) {
  return fill("throng_spring_chain_fill", into, size);
}
int throng_spring_collider_fill(throng_spring_collider* into, size_t size) {
  return fill("throng_spring_collider_fill", into, size);
}
int throng_springs_fill(throng_springs* into, size_t size) { return fill("throng_springs_fill", into, size); }
int throng_ragdoll_fill(throng_ragdoll* into, size_t size) { return fill("throng_ragdoll_fill", into, size); }
int throng_socket_fill(throng_socket* into, size_t size) { return fill("throng_socket_fill", into, size); }

uint32_t throng_agent_add_look_at(throng_crowd* crowd, throng_id agent, const throng_look_at* settings) {
  const Call call("throng_agent_add_look_at");
  return add_process(call, "throng_look_at", crowd, agent, settings, [](const Agent& own, const throng_look_at& c) {
    return own.add(
        LookAt{.yaw = c.yaw, .pitch_up = c.pitch_up, .pitch_down = c.pitch_down, .smooth_seconds = c.smooth_seconds});
  });
}

uint32_t throng_agent_add_reach(throng_crowd* crowd, throng_id agent, const throng_reach* settings) {
  const Call call("throng_agent_add_reach");
  if (call.is_missing(crowd)) return THRONG_NONE;
  const auto read = call.read("throng_reach", settings);
  if (!read || !call.is_constant("throng_reach::limb", read->limb, Limb::right_leg)) return THRONG_NONE;
  return number_or_none(
      agent_of(crowd, agent)
          .add(
              Reach{.limb = static_cast<Limb>(read->limb), .softness = read->softness, .pole = vector_of(read->pole)}));
}

uint32_t throng_agent_add_chain_reach(throng_crowd* crowd, throng_id agent, const throng_chain_reach* settings) {
  const Call call("throng_agent_add_chain_reach");
  return add_process(call, "throng_chain_reach", crowd, agent, settings,
                     [](const Agent& own, const throng_chain_reach& c) {
                       constexpr std::uint32_t most = 1'000'000;  // more would not fit the setting
                       return own.add(ChainReach{.first = view_of(c.first),
                                                 .last = view_of(c.last),
                                                 .iterations = static_cast<int>(std::min(c.iterations, most)),
                                                 .tolerance = c.tolerance});
                     });
}

uint32_t throng_agent_add_foot_placement(throng_crowd* crowd, throng_id agent, const throng_foot_placement* settings) {
  const Call call("throng_agent_add_foot_placement");
  return add_process(call, "throng_foot_placement", crowd, agent, settings,
                     [](const Agent& own, const throng_foot_placement& c) {
                       return own.add(FootPlacement{.max_drop = c.max_drop, .farthest_lock = c.farthest_lock});
                     });
}

uint32_t throng_agent_add_noise(throng_crowd* crowd, throng_id agent, const throng_noise* settings) {
  const Call call("throng_agent_add_noise");
  return add_process(call, "throng_noise", crowd, agent, settings, [](const Agent& own, const throng_noise& c) {
    return own.add(Noise{.frequency = c.frequency, .amplitude = c.amplitude, .seed = c.seed, .mask = {c.mask}});
  });
}

uint32_t throng_agent_add_springs(throng_crowd* crowd, throng_id agent, const throng_springs* settings) {
  const Call call("throng_agent_add_springs");
  if (call.is_missing(crowd, settings)) return THRONG_NONE;
  const auto read = call.read("throng_springs", settings);
  if (!read) return THRONG_NONE;
  if (call.lacks(read->chains, read->chain_count) || call.lacks(read->colliders, read->collider_count)) {
    return THRONG_NONE;
  }
  std::vector<SpringChain> chains;
  std::vector<SpringCollider> colliders;
  std::ranges::transform(std::span(read->chains, read->chain_count), std::back_inserter(chains), chain_of);
  std::ranges::transform(std::span(read->colliders, read->collider_count), std::back_inserter(colliders), collider_of);
  return number_or_none(agent_of(crowd, agent).add(Springs{.chains = chains, .colliders = colliders}));
}

uint32_t throng_agent_add_ragdoll(throng_crowd* crowd, throng_id agent, const throng_ragdoll* settings) {
  const Call call("throng_agent_add_ragdoll");
  return add_process(call, "throng_ragdoll", crowd, agent, settings, [](const Agent& own, const throng_ragdoll& c) {
    return own.add(Ragdoll{.fade = ticks_of(c.fade)});
  });
}

uint32_t throng_agent_add_socket(throng_crowd* crowd, throng_id agent, const throng_socket* settings) {
  const Call call("throng_agent_add_socket");
  return add_process(call, "throng_socket", crowd, agent, settings, [](const Agent& own, const throng_socket& c) {
    return own.add(Socket{.bone = static_cast<int>(c.bone), .offset = place_of(c.offset)});
  });
}
