#include "engine/anim/run/store/tile_scratch.h"

namespace throng::anim {

ModelScratch ModelScratch::carve(ScratchCarver& carver, int width, const UpdateContext& context, bool with_local) {
  const auto lanes = static_cast<std::size_t>(width);
  const std::size_t slot_floats = static_cast<std::size_t>(branch_slot_floats) * lanes;
  const std::size_t branch_floats = slot_floats * static_cast<std::size_t>(context.hierarchy->slot_count);
  ModelScratch scratch;
  if (with_local) scratch.local = carver.carve<float>(lanes * context.packet_floats());
  scratch.carry = carver.carve<float>(slot_floats);
  scratch.branches = carver.carve<float>(branch_floats);
  scratch.palettes = carver.carve<PaletteDestination>(lanes);
  scratch.hashes = carver.carve<std::uint64_t>(lanes);
  if (context.joint_programs.empty()) return scratch;
  scratch.joint_carry = carver.carve<float>(slot_floats);
  scratch.joint_branches = carver.carve<float>(branch_floats);
  scratch.joints = carver.carve<float*>(lanes);
  return scratch;
}

}  // namespace throng::anim
