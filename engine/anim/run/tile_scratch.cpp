#include "engine/anim/run/tile_scratch.h"

#include "engine/anim/run/bone_fade.h"

namespace throng::anim {

ModelScratch ModelScratch::carve(ScratchCarver& carver, int width, int components, int slots, bool with_local) {
  const auto lanes = static_cast<std::size_t>(width);
  const std::size_t slot_floats = static_cast<std::size_t>(branch_slot_floats) * lanes;
  ModelScratch scratch;
  if (with_local) scratch.local = carver.carve<float>(lanes * packet_bytes(components) / sizeof(float));
  scratch.carry = carver.carve<float>(slot_floats);
  scratch.branches = carver.carve<float>(slot_floats * static_cast<std::size_t>(slots));
  scratch.palettes = carver.carve<PaletteDestination>(lanes);
  scratch.hashes = carver.carve<std::uint64_t>(lanes);
  return scratch;
}

void begin_palettes(ModelScratch& scratch, const UpdateContext& context, std::span<const AgentWork> tile, int width,
                    const PaletteStores& stores) {
  scratch.fades = false;
  for (std::size_t i = 0; i < tile.size(); ++i) {
    scratch.palettes[i] = tile[i].palette == nullptr ? PaletteDestination(stores.unseen) : tile[i].palette;
    scratch.hashes[i] = 0;
    scratch.fades = scratch.fades || tile[i].fade_halves != 0;
  }
  scratch.job = {.hierarchy = context.hierarchy,
                 .bone_count = context.bones(tile.front().level),
                 .width = width,
                 .characters = static_cast<int>(tile.size()),
                 .stores = stores.policy,
                 .carry = scratch.carry.data(),
                 .branch_slots = scratch.branches.data(),
                 .format = context.palette_format,
                 .palettes = scratch.palettes.data(),
                 .hashes = context.hashes.empty() ? nullptr : scratch.hashes.data()};
}

void model_palette_packet(const UpdateContext& context, const ModelScratch& scratch, std::span<const AgentWork> tile,
                          const TilePacket& about) {
  for (std::size_t i = 0; scratch.fades && i < tile.size(); ++i) {
    if (tile[i].fade_halves == 0) continue;
    fade_bones(context, tile[i], about.packet, about.displaced, about.local + i * context.packet_floats());
  }
  ModelPaletteJob job = scratch.job;  // which has left the nearest cache; the kernel reads it bone by bone
  job.packet = about.packet;
  job.local = about.local;
  job.displaced = about.displaced;
  context.assets.kernels->model_palette(job);
}

void store_hashes(const UpdateContext& context, const ModelScratch& scratch, std::span<const AgentWork> tile) {
  if (context.hashes.empty()) return;
  for (std::size_t i = 0; i < tile.size(); ++i) context.hashes[tile[i].agent] = scratch.hashes[i];
}

}  // namespace throng::anim
