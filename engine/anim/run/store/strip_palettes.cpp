#include "engine/anim/run/store/strip_palettes.h"

#include <algorithm>

#include "engine/anim/run/program/bone_fade.h"
#include "engine/anim/run/store/local_transforms.h"

namespace throng::anim {

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
