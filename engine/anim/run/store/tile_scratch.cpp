#include "engine/anim/run/store/tile_scratch.h"

#include <algorithm>

namespace throng::anim {
namespace {

/// Returns the branch slots that lists of joints need at any level.
int joint_slots(const UpdateContext& context) {
  int slots = 0;
  for (const JointProgram& program : context.joint_programs) slots = std::max(slots, program.hierarchy.slot_count);
  return slots;
}

}  // namespace

ModelScratch ModelScratch::carve(ScratchCarver& carver, int width, const UpdateContext& context, bool with_local) {
  const auto lanes = static_cast<std::size_t>(width);
  const std::size_t slot_floats = static_cast<std::size_t>(branch_slot_floats) * lanes;
  const auto carve_slots = [&](int slots) {
    return carver.carve<float>(slot_floats * static_cast<std::size_t>(slots));
  };
  const int for_joints = joint_slots(context), for_palettes = context.hierarchy->slot_count;
  // Matrices are made on the walk that writes joints, so both share its memory.
  const bool share = context.palette_format == PaletteFormat::matrices;
  ModelScratch scratch;
  if (with_local) scratch.local = carver.carve<float>(lanes * context.packet_floats());
  scratch.carry = carve_slots(1);
  scratch.branches = carve_slots(share ? std::max(for_joints, for_palettes) : for_palettes);
  scratch.palettes = carver.carve<PaletteDestination>(lanes);
  scratch.hashes = carver.carve<std::uint64_t>(lanes);
  if (context.joint_programs.empty()) return scratch;
  scratch.joint_carry = share ? scratch.carry : carve_slots(1);
  scratch.joint_branches = share ? scratch.branches : carve_slots(for_joints);
  scratch.joints = carver.carve<float*>(lanes);
  return scratch;
}

}  // namespace throng::anim
