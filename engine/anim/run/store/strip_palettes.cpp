#include "engine/anim/run/store/strip_palettes.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace throng::anim {
namespace {

constexpr float whole_way = 2.0F;  // halves
constexpr int rotation_components = 4;

/// A bone's component in a packet.
float& component_of(float* packet, int component, int lane) { return packet[component * packet_bones + lane]; }
float component_of(const float* packet, int component, int lane) { return packet[component * packet_bones + lane]; }

/// The shorter way round, back to unit length.
void fade_rotation(const float* still, int lane, float share, float* pose) {
  float cosine = 0.0F;
  for (int i = 0; i < rotation_components; ++i) cosine += component_of(still, i, lane) * component_of(pose, i, lane);
  const float side = cosine < 0.0F ? -1.0F : 1.0F;
  float squares = 0.0F;
  for (int i = 0; i < rotation_components; ++i) {
    float& value = component_of(pose, i, lane);
    value = (1.0F - share) * value + share * side * component_of(still, i, lane);
    squares += value * value;
  }
  const float length = std::sqrt(squares);
  for (int i = 0; i < rotation_components; ++i) component_of(pose, i, lane) /= length;
}

/// Takes the bones of one packet that AgentWork::fade_level lacks half or all of the way to where they stand still.
/// `pose` is float [components][16]. Positions of quads that are not `displaced` are 0 and not stored.
void fade_bones(const UpdateContext& context, const AgentWork& work, int packet, QuadMask displaced, float* pose) {
  const int components = context.assets.components;
  const int kept = context.bones(work.fade_level) - packet * packet_bones;
  if (work.fade_halves == 0 || kept >= packet_bones) return;
  assert(!context.still_pose.empty() && "the context lacks the still pose");
  const float share = static_cast<float>(work.fade_halves) / whole_way;
  const float* still = &context.still_pose[static_cast<std::size_t>(packet) * context.packet_floats()];
  for (int lane = std::max(kept, 0); lane < packet_bones; ++lane) {
    fade_rotation(still, lane, share, pose);
    const int last_component = is_in(displaced, lane / quad_bones) ? components : rotation_components;
    for (int i = rotation_components; i < last_component; ++i) {
      float& value = component_of(pose, i, lane);
      value = (1.0F - share) * value + share * component_of(still, i, lane);
    }
  }
}

/// Writes local transforms of the bones of one packet of a character, as Bone::rest has them: prefix * T * R * S is the
/// bone in the space of its parent. `state` is [components][16]; `locals` has room for every bone.
void write_locals(const Skeleton& skeleton, int packet, QuadMask displaced, const float* state, Transform* locals) {
  const int first = packet * packet_bones;
  const int count = std::min(packet_bones, skeleton.bone_count() - first);
  for (int i = 0; i < count; ++i) {
    const auto value = [&](int component) { return static_cast<double>(state[component * packet_bones + i]); };
    StateTransform relative{.rotation = glm::dquat(value(3), value(0), value(1), value(2))};
    if (!skeleton.rigid || is_in(displaced, i / quad_bones)) relative.position = {value(4), value(5), value(6)};
    if (!skeleton.rigid) relative.scale = {value(7), value(8), value(9)};
    const StateTransform local = to_local(skeleton, first + i, relative);
    locals[first + i] = {.translation = glm::vec3(local.position),
                         .rotation = glm::quat(glm::normalize(local.rotation)),
                         .scale = glm::vec3(local.scale)};
  }
}

}  // namespace

StripPalettes::StripPalettes(const UpdateContext& context, const ModelScratch& scratch,
                             std::span<const AgentWork> strip, int width, const PaletteStores& stores)
    : job_{.hierarchy = context.hierarchy,
           .bone_count = context.bones(strip.front().level),
           .width = width,
           .characters = static_cast<int>(strip.size()),
           .stores = stores.policy,
           .carry = scratch.carry.data(),
           .branch_slots = scratch.branches.data(),
           .format = context.palette_format,
           .palettes = scratch.palettes.data(),
           .hashes = context.hashes.empty() ? nullptr : scratch.hashes.data()},
      model_palette_(context.assets.kernels->model_palette),
      joints_(context, scratch, strip, width, reinterpret_cast<float*>(stores.unseen)),
      makes_palettes_(!context.hashes.empty()),
      context_(&context),
      strip_(strip) {
  for (std::size_t i = 0; i < strip.size(); ++i) {
    scratch.palettes[i] = strip[i].palette == nullptr ? PaletteDestination(stores.unseen) : strip[i].palette;
    makes_palettes_ = makes_palettes_ || strip[i].palette != nullptr;
    fades_ = fades_ || strip[i].fade_halves != 0;
  }
  if (job_.hashes != nullptr) std::ranges::fill(scratch.hashes, 0);
  joints_with_palettes_ = makes_palettes_ && context.locals_of == nullptr && job_.format == PaletteFormat::matrices;
  if (joints_with_palettes_) joints_.write_with_palettes(job_);
}

void StripPalettes::write(const StripPacket& about) {
  if (fades_) fade(about);
  if (!joints_with_palettes_) joints_.write(about);
  if (!makes_palettes_) return;
  if (context_->locals_of != nullptr) [[unlikely]]
    return write_local_transforms(about);
  job_.packet = about.packet;
  job_.local = about.local;
  job_.displaced = about.displaced;
  model_palette_(job_);
}

void StripPalettes::fade(const StripPacket& about) const {
  for (std::size_t i = 0; i < strip_.size(); ++i) {
    fade_bones(*context_, strip_[i], about.packet, about.displaced, about.local + i * context_->packet_floats());
  }
}

void StripPalettes::write_local_transforms(const StripPacket& about) const {
  for (std::size_t i = 0; i < strip_.size(); ++i) {
    write_locals(*context_->locals_of, about.packet, about.displaced, about.local + i * context_->packet_floats(),
                 reinterpret_cast<Transform*>(strip_[i].palette.memory()));
  }
}

void StripPalettes::store_hashes() const {
  if (job_.hashes == nullptr) return;
  for (std::size_t i = 0; i < strip_.size(); ++i) context_->hashes[strip_[i].agent] = job_.hashes[i];
}

}  // namespace throng::anim
