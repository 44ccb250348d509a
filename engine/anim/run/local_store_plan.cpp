#include "engine/anim/run/local_store_plan.h"

#include <algorithm>
#include <bit>

#include "engine/anim/run/fused_tasks.h"
#include "engine/anim/run/level_tasks.h"

namespace throng::anim {
namespace {

constexpr std::size_t kib = 1024;

std::uint32_t largest_player(const UpdateContext& context, const LocalStoreDemand& demand) {
  std::uint32_t size = 0;
  if (demand.any_sampled) size = context.pools->layout(EntityPools::sampled_players).total_size;
  if (demand.any_keyframe) size = std::max(size, context.pools->layout(EntityPools::keyframe_players).total_size);
  return size;
}

LocalStorePlan plan_for_width(const UpdateContext& context, const LocalStoreDemand& demand, int width) {
  const std::uint32_t player = largest_player(context, demand);
  if (demand.schedule == Schedule::fused) {
    return {.width = width,
            .fetch_bytes = FusedTasks::fetch_bytes(context, width, player),
            .scratch_bytes = FusedTasks::scratch_bytes(context, width)};
  }
  const std::uint32_t source = context.pools->layout(EntityPools::ease_blenders).source_bytes();
  return {.width = width,
          .fetch_bytes =
              std::max(EntityTasks::fetch_bytes(context, player, source), PaletteTasks::fetch_bytes(context, width)),
          .scratch_bytes = PaletteTasks::scratch_bytes(context, width)};
}

std::size_t plan_bytes(const LocalStorePlan& plan, DoubleBuffering mode) {
  return plan.fetch_bytes * (mode == DoubleBuffering::off ? 1 : 2) + plan.scratch_bytes;
}

int widest(const UpdateContext& context, const LocalStoreDemand& demand, std::size_t size) {
  int width = widest_tile;
  while (width > 0 && local_store_bytes(context, demand, width) > size) width /= 2;
  return width;
}

std::string in_words(const LocalStoreDemand& demand) {
  return "skeleton \"" + demand.skeleton + "\" with schedule " +
         (demand.schedule == Schedule::fused ? "fused" : "levels") + " and stream " +
         (demand.any_keyframe ? "keyframe" : "sampled");
}

Error too_small(const UpdateContext& context, const LocalStoreDemand& demand, std::size_t size) {
  const std::size_t needed = local_store_bytes(context, demand, 1);
  return {in_words(demand) + " needs " + std::to_string(needed) + " bytes of local store for one character, not " +
          std::to_string(size) + ": the smallest --local-store that works is " +
          std::to_string((needed + kib - 1) / kib)};
}

Error too_wide(const LocalStoreDemand& demand, std::size_t size, int tile, int fits) {
  return {"a tile of " + std::to_string(tile) + " characters does not fit the local store of " +
          std::to_string(size / kib) + " KiB for " + in_words(demand) + ": the largest --tile that fits is " +
          std::to_string(fits)};
}

}  // namespace

std::size_t local_store_bytes(const UpdateContext& context, const LocalStoreDemand& demand, int width) {
  return plan_bytes(plan_for_width(context, demand, width), demand.double_buffering);
}

Result<LocalStorePlan> plan_local_store(const UpdateContext& context, const LocalStoreDemand& demand, std::size_t size,
                                        int tile) {
  const int fits = widest(context, demand, size);
  if (fits == 0) return too_small(context, demand, size);
  if (tile > fits) return too_wide(demand, size, tile, fits);
  return plan_for_width(context, demand, tile == 0 ? fits : tile);
}

std::size_t automatic_local_store(const UpdateContext& context, const LocalStoreDemand& demand) {
  return std::max(usual_local_store_bytes, std::bit_ceil(local_store_bytes(context, demand, 1)));
}

}  // namespace throng::anim
