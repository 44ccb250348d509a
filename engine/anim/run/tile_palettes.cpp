#include "engine/anim/run/tile_palettes.h"

#include <algorithm>

#include "engine/anim/run/bone_fade.h"

namespace throng::anim {

TilePalettes::TilePalettes(const UpdateContext& context, const ModelScratch& scratch, std::span<const AgentWork> tile,
                           int width, const PaletteStores& stores)
    : job_{.hierarchy = context.hierarchy,
           .bone_count = context.bones(tile.front().level),
           .width = width,
           .characters = static_cast<int>(tile.size()),
           .stores = stores.policy,
           .carry = scratch.carry.data(),
           .branch_slots = scratch.branches.data(),
           .format = context.palette_format,
           .palettes = scratch.palettes.data(),
           .hashes = context.hashes.empty() ? nullptr : scratch.hashes.data()},
      model_palette_(context.assets.kernels->model_palette),
      context_(&context),
      tile_(tile) {
  for (std::size_t i = 0; i < tile.size(); ++i) {
    scratch.palettes[i] = tile[i].palette == nullptr ? PaletteDestination(stores.unseen) : tile[i].palette;
    fades_ = fades_ || tile[i].fade_halves != 0;
  }
  if (job_.hashes != nullptr) std::ranges::fill(scratch.hashes, 0);
}

void TilePalettes::write(const TilePacket& about) {
  if (fades_) fade(about);
  job_.packet = about.packet;
  job_.local = about.local;
  job_.displaced = about.displaced;
  model_palette_(job_);
}

void TilePalettes::fade(const TilePacket& about) const {
  for (std::size_t i = 0; i < tile_.size(); ++i) {
    fade_bones(*context_, tile_[i], about.packet, about.displaced, about.local + i * context_->packet_floats());
  }
}

void TilePalettes::store_hashes() const {
  if (job_.hashes == nullptr) return;
  for (std::size_t i = 0; i < tile_.size(); ++i) context_->hashes[tile_[i].agent] = job_.hashes[i];
}

}  // namespace throng::anim
