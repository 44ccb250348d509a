#include "engine/anim/run/fused_scratch.h"

#include <algorithm>

#include "engine/anim/run/local_store_plan.h"

namespace throng::anim {

FusedScratch FusedScratch::carve(ScratchCarver& carver, const UpdateContext& context, const StoreNeeds& needs,
                                 int width) {
  const auto lanes = static_cast<std::size_t>(width);
  const std::size_t packet_floats = context.packet_floats();
  const int held_packets = std::min<int>(needs.held_packets, context.packets(0));
  const std::size_t held_floats = packet_floats * static_cast<std::size_t>(held_packets);
  FusedScratch scratch;
  scratch.model =
      ModelScratch::carve(carver, width, context.assets.components, context.hierarchy->slot_count, !needs.held);
  scratch.register_floats = needs.held ? held_floats : packet_floats;
  scratch.registers = carver.carve<float>(scratch.register_floats * needs.registers);
  scratch.prepared = carver.carve<std::byte>(lanes * needs.prepared_bytes);
  if (!needs.held) return scratch;
  scratch.held = carver.carve<float>(lanes * held_floats);
  scratch.model.local = scratch.held.first(scratch.held.empty() ? 0 : lanes * packet_floats);
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
