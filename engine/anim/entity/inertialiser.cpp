#include "engine/anim/entity/inertialiser.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "engine/anim/entity/entity_run.h"
#include "engine/anim/entity/reorder_lanes.h"

namespace throng::anim {
namespace {

using Capture = Inertialiser::Capture;

constexpr std::size_t offset_floats = std::size_t{offset_components} * packet_bones;

struct Offsets {
  float offsets[offset_components][packet_bones];
  float velocities[offset_components][packet_bones];
};
static_assert(sizeof(Offsets) == 2 * offset_floats * sizeof(float));

/// The values that an update uses in each packet.
struct Plan {
  Capture capture;
  OffsetDecay decay;      ///< of the present offset
  float seconds_between;  ///< from the first to the second update of a capture
  int captured;           ///< packets that have an offset
};
constexpr OffsetDecay undiminished = {.offset = 1.0F, .velocity = 0.0F};

std::size_t offset_bytes(int bone_count, int) {
  return static_cast<std::size_t>(packets_for(bone_count)) * sizeof(Offsets);
}

std::span<Handle> source_of_inertialiser(std::byte* block, const EntityLayout&) {
  static_assert(offsetof(Inertialiser, leaving) == offsetof(Inertialiser, target) + sizeof(Handle));
  auto& inertialiser = *reinterpret_cast<Inertialiser*>(block);
  return {&inertialiser.target, has_left(inertialiser) ? 1U : 2U};
}

OffsetDecay decay_now(const Inertialiser& inertialiser) {
  if (inertialiser.settled != 0) return undiminished;
  const float half_life = has_left(inertialiser) ? inertialiser.half_life : inertialiser.old_half_life;
  const Ticks decayed = std::max(inertialiser.since_capture, Ticks{});  // it may be wound back, at most to the capture
  return offset_decay(static_cast<float>(to_seconds(decayed)), half_life);
}

// No time has passed since the first half, so there is no velocity yet.
Capture next_capture(const Inertialiser& inertialiser, Ticks delta) {
  const bool again = inertialiser.capture == Capture::second && delta <= Ticks{};
  return again ? Capture::first : inertialiser.capture;
}

void advance_inertialiser(const EntityInStore& entity, const SourcesInStore& sources) {
  auto& inertialiser = entity.as<Inertialiser>();
  const Ticks delta = inertialiser.state.delta_time;
  inertialiser.state.delta_time = Ticks{};
  inertialiser.since_capture += delta;
  const Plan plan = {.capture = next_capture(inertialiser, delta),
                     .decay = decay_now(inertialiser),
                     .seconds_between = static_cast<float>(to_seconds(delta)),
                     .captured = inertialiser.captured};
  entity.prepared_as<Plan>() = plan;
  inertialiser.settled = plan.capture == Capture::first ? 1 : 0;
  inertialiser.capture = plan.capture == Capture::first ? Capture::second : Capture::none;
  if (plan.capture == Capture::second) inertialiser.since_capture = Ticks{};
  take_velocity(inertialiser.state, sources[0]);
}

// From here on the old offset is its value alone, without a velocity.
void settle(Offsets& offsets, OffsetDecay decay) {
  for (int component = 0; component < offset_components; ++component) {
    for (int bone = 0; bone < packet_bones; ++bone) {
      float& offset = offsets.offsets[component][bone];
      offset = offset * decay.offset + offsets.velocities[component][bone] * decay.velocity;
    }
  }
}

// A jump of the pose shown is not a velocity; see fastest_offset_turn.
void limit(float (&vectors)[offset_components][packet_bones], int first, float longest) {
  for (int bone = 0; bone < packet_bones; ++bone) {
    float* const x = &vectors[first][bone];
    float* const y = &vectors[first + 1][bone];
    float* const z = &vectors[first + 2][bone];
    const float length = std::sqrt(*x * *x + *y * *y + *z * *z);
    const float scale = length > longest ? longest / length : 1.0F;
    *x *= scale;
    *y *= scale;
    *z *= scale;
  }
}

void differentiate(Offsets& offsets, float seconds) {
  for (int component = 0; component < offset_components; ++component) {
    for (int bone = 0; bone < packet_bones; ++bone) {
      float& before = offsets.velocities[component][bone];
      before = (offsets.offsets[component][bone] - before) / seconds;
    }
  }
  limit(offsets.velocities, 0, fastest_offset_turn);
  limit(offsets.velocities, 3, fastest_offset_move);
}

void apply(const EntityInStore& entity, const Offsets& offsets, OffsetDecay decay, const float* target, float* out) {
  entity.assets->kernels->apply_offset({.target = target,
                                        .offsets = offsets.offsets[0],
                                        .velocities = offsets.velocities[0],
                                        .decay = decay,
                                        .components = entity.assets->components,
                                        .out = out});
}

/// Captures the offset from `target` to `shown`.
void measure(const EntityInStore& entity, const float* shown, const float* target, float* offsets) {
  alignas(64) float no_velocities[offset_components * packet_bones];
  entity.assets->kernels->capture_offset(
      {.shown = shown, .target = target, .offsets = offsets, .velocities = no_velocities});
}

void inertialise_packet(const EntityInStore& entity, const PacketJob& job) {
  const auto& plan = entity.prepared_as<Plan>();
  Offsets& offsets = reinterpret_cast<Offsets*>(entity.private_part().data())[job.packet];
  const bool has_offset = job.packet < plan.captured;
  if (plan.capture == Capture::none) {
    return apply(entity, offsets, has_offset ? plan.decay : OffsetDecay{}, job.sources[0], job.out);
  }
  if (!has_offset) offsets = {};
  entity.as<Inertialiser>().captured = static_cast<std::uint16_t>(job.packet + 1);
  alignas(64) float shown[general_components * packet_bones];
  apply(entity, offsets, plan.decay, job.sources[1], shown);
  if (plan.capture == Capture::first) {
    settle(offsets, plan.decay);
    measure(entity, shown, job.sources[0], offsets.velocities[0]);
  } else {
    measure(entity, shown, job.sources[0], offsets.offsets[0]);
    if (has_offset) differentiate(offsets, plan.seconds_between);
  }
  std::memcpy(job.out, shown, packet_bytes(entity.assets->components));
}

// Bones move among all packets, so packets without an offset get a zero offset. No velocity of these is half measured,
// so the measurement begins again.
void reorder_offsets(std::byte* block, const EntityLayout& layout, std::span<const int> places) {
  auto& inertialiser = *reinterpret_cast<Inertialiser*>(block);
  auto* const offsets = reinterpret_cast<Offsets*>(block + layout.private_offset);
  const int packets = packets_for(static_cast<int>(places.size()));
  if (inertialiser.captured < packets) {
    std::fill(offsets + inertialiser.captured, offsets + packets, Offsets{});
    inertialiser.captured = static_cast<std::uint16_t>(packets);
    if (inertialiser.capture == Capture::second) inertialiser.capture = Capture::first;
  }
  reorder_lanes(places, 2 * offset_components, offsets->offsets[0]);
}

}  // namespace

void retarget(Inertialiser& inertialiser, Handle target, Handle leaving, float half_life) {
  if (has_left(inertialiser)) inertialiser.old_half_life = inertialiser.half_life;
  inertialiser.target = target;
  inertialiser.leaving = leaving;
  inertialiser.half_life = half_life;
  inertialiser.capture = Capture::first;
}

bool is_over(const Inertialiser& inertialiser) {
  const OffsetDecay decay = decay_now(inertialiser);
  return has_left(inertialiser) && decay.offset == 0.0F && decay.velocity == 0.0F;
}

const EntityKind inertialiser_kind = {.name = "inertialiser",
                                      .type = EntityType::inertialiser,
                                      .sources = source_of_inertialiser,
                                      .private_bytes_for = offset_bytes,
                                      .reorder_bones = reorder_offsets,
                                      .prepared_bytes = 64,
                                      .reads_identity = false,
                                      .advance = advance_each<advance_inertialiser>,
                                      .pose_packet = inertialise_packet};

}  // namespace throng::anim
