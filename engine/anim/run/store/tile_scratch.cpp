#include "engine/anim/run/store/tile_scratch.h"

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

}  // namespace throng::anim
