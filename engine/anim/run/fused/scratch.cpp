#include "engine/anim/run/fused/scratch.h"

#include <algorithm>

#include "engine/anim/run/store/local_store.h"

namespace throng::anim {

FusedScratch FusedScratch::carve(ScratchCarver& carver, const UpdateContext& context, const StoreNeeds& needs,
                                 int width, std::size_t characters) {
  const auto lanes = static_cast<std::size_t>(width);
  const std::size_t packet_floats = context.packet_floats();
  const int held_packets = std::min<int>(needs.held_packets, context.packets(0));
  const std::size_t held_floats = packet_floats * static_cast<std::size_t>(held_packets);
  FusedScratch scratch;
  scratch.prepared = carver.carve<std::byte>(characters * needs.prepared_bytes);
  scratch.model = ModelScratch::carve(carver, width, context, !needs.held);
  scratch.register_floats = needs.held ? held_floats : packet_floats;
  scratch.registers = carver.carve<float>(scratch.register_floats * needs.registers);
  if (!needs.held) return scratch;
  scratch.held = carver.carve<float>(lanes * held_floats);
  scratch.model.local = scratch.held.first(scratch.held.empty() ? 0 : lanes * packet_floats);
  return scratch;
}

std::size_t FusedScratch::bytes(const UpdateContext& context, const StoreNeeds& needs, int width,
                                std::size_t characters) {
  ScratchCarver carver({});
  carve(carver, context, needs, width, characters);
  return carver.used();
}

FusedFit fused_fit(const UpdateContext& context, const StoreNeeds& needs, std::size_t shared_bytes,
                   const LocalStorePlan& plan) {
  const auto fit = [&](int width, int strips) {
    const std::size_t characters = static_cast<std::size_t>(width) * static_cast<std::size_t>(strips);
    return shared_bytes + characters * needs.fetch_bytes <= plan.fetch_bytes &&
           FusedScratch::bytes(context, needs, width, characters) <= plan.scratch_bytes;
  };
  int width = plan.width;
  while (width > 0 && !fit(width, 1)) width /= 2;
  int strips = width == plan.width ? plan.strips : 1;
  while (strips > 1 && !fit(width, strips)) --strips;
  return {.width = width, .characters = width * strips};
}

}  // namespace throng::anim
