#include "engine/anim/run/fused_scratch.h"

#include "engine/anim/run/local_store_plan.h"

namespace throng::anim {

FusedScratch FusedScratch::carve(ScratchCarver& carver, const UpdateContext& context, const StoreNeeds& needs,
                                 int width) {
  const auto lanes = static_cast<std::size_t>(width);
  const std::size_t packet_floats = context.packet_floats();
  const std::size_t pose_floats = packet_floats * static_cast<std::size_t>(context.packets(0));
  FusedScratch scratch;
  scratch.model =
      ModelScratch::carve(carver, width, context.assets.components, context.hierarchy->slot_count, !needs.held);
  scratch.register_floats = needs.held ? pose_floats : packet_floats;
  scratch.registers = carver.carve<float>(scratch.register_floats * needs.registers);
  scratch.prepared = carver.carve<std::byte>(lanes * needs.prepared_bytes);
  if (needs.held) scratch.held = carver.carve<float>(lanes * pose_floats);
  return scratch;
}

std::size_t FusedScratch::bytes(const UpdateContext& context, const StoreNeeds& needs, int width) {
  ScratchCarver carver({});
  carve(carver, context, needs, width);
  return carver.used();
}

int widest_fused_tile(const UpdateContext& context, const StoreNeeds& needs, std::size_t shared_bytes,
                      const LocalStorePlan& plan) {
  int width = widest_tile;
  while (width > 0 && (shared_bytes + static_cast<std::size_t>(width) * needs.fetch_bytes > plan.fetch_bytes ||
                       FusedScratch::bytes(context, needs, width) > plan.scratch_bytes)) {
    width /= 2;
  }
  return width;
}

}  // namespace throng::anim
