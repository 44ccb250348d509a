#include "engine/anim/run/local_store_plan.h"

#include <algorithm>
#include <bit>

#include "engine/anim/run/fused/scratch.h"
#include "engine/anim/run/levels/level_tasks.h"

namespace throng::anim {
namespace {

constexpr std::size_t kib = 1024;

// Most graphs are no larger: clips that fade into each other.
constexpr std::uint32_t usual_players = 4;
constexpr std::uint32_t usual_blenders = usual_players - 1;

std::uint32_t largest_player(const UpdateContext& context, const LocalStoreDemand& demand) {
  std::uint32_t size = 0;
  for (const ClipStreams& clip : context.assets.clips) {
    if (clip.is_empty()) continue;
    const bool sampled = clip.played(demand.stream) == StreamKind::sampled;
    const auto kind = sampled ? EntityPools::sampled_players : EntityPools::keyframe_players;
    size = std::max(size, context.pools->layout(kind).total_size);
  }
  return size;
}

StoreNeeds usual_needs(const UpdateContext& context, const LocalStoreDemand& demand) {
  const std::uint32_t player = largest_player(context, demand);
  const EntityLayout& blender = context.pools->layout(EntityPools::ease_blenders);
  return {.fetch_bytes = usual_players * player + usual_blenders * blender.total_size,
          .entity_bytes = std::max(player, blender.total_size + 2 * blender.source_bytes()),
          .prepared_bytes = usual_players * static_cast<std::uint32_t>(sampled_player_kind.prepared_bytes),
          .registers = usual_players};
}

/// A new clip over a fade that is interrupted is the most that a cross-fading channel makes.
StoreNeeds interrupted_fade_needs(const UpdateContext& context, const LocalStoreDemand& demand) {
  const EntityLayout& inertialiser = context.pools->layout(EntityPools::inertialisers);
  const EntityLayout& blender = context.pools->layout(EntityPools::ease_blenders);
  return {.fetch_bytes = 3 * largest_player(context, demand) + blender.total_size + inertialiser.total_size,
          .entity_bytes = inertialiser.total_size + 2 * blender.source_bytes(),
          .prepared_bytes = 4 * static_cast<std::uint32_t>(sampled_player_kind.prepared_bytes),
          .registers = 3};
}

/// Returns the size of each buffer, so that all together hold `bytes`.
std::size_t share_of_buffers(std::size_t bytes, int buffers) {
  return (bytes / static_cast<std::size_t>(buffers) + 63) / 64 * 64;
}

LocalStorePlan plan_for_context(const UpdateContext& context, const LocalStoreDemand& demand, int width) {
  const StoreNeeds usual = usual_needs(context, demand);
  StoreNeeds largest = demand.largest;
  largest.widen(interrupted_fade_needs(context, demand));
  const auto lanes = static_cast<std::size_t>(width);
  const int buffers = demand.double_buffering == DoubleBuffering::off ? 1 : 2;
  const std::size_t shared_entity = share_of_buffers(demand.shared_entity_bytes, buffers);
  if (demand.schedule == Schedule::fused) {
    const std::size_t tile = std::max<std::size_t>(lanes * usual.fetch_bytes, largest.fetch_bytes);
    return {.width = width,
            .fetch_bytes = std::max(tile + largest.shared_bytes, shared_entity),
            .fetch_buffers = buffers,
            .scratch_bytes = std::max(FusedScratch::bytes(context, usual, width, lanes),
                                      FusedScratch::bytes(context, largest, 1, 1)),
            .shared_bytes = largest.shared_bytes};
  }
  const std::size_t large_entity = share_of_buffers(largest.entity_bytes, buffers);
  return {.width = width,
          .fetch_bytes = std::max<std::size_t>(
              {usual.entity_bytes, large_entity, shared_entity, PaletteTasks::fetch_bytes(context, width)}),
          .fetch_buffers = buffers,
          .scratch_bytes = std::max(EntityTasks::scratch_bytes, PaletteTasks::scratch_bytes(context, width))};
}

// The tile is as wide as the largest skeleton allows; under `fused` others get as many characters as fit, at least 1.
LocalStorePlan plan_for_width(std::span<const UpdateContext> contexts, const LocalStoreDemand& demand, int width) {
  const auto bones = [](const UpdateContext& context) { return context.assets.bone_count; };
  const auto largest = std::ranges::max_element(contexts, {}, bones);
  LocalStorePlan plan{.width = width};
  for (const UpdateContext& context : contexts) {
    const bool decides = demand.schedule == Schedule::levels || bones(context) == bones(*largest);
    const LocalStorePlan part = plan_for_context(context, demand, decides ? width : 1);
    plan.fetch_bytes = std::max(plan.fetch_bytes, part.fetch_bytes);
    plan.fetch_buffers = part.fetch_buffers;
    plan.scratch_bytes = std::max(plan.scratch_bytes, part.scratch_bytes);
    plan.shared_bytes = std::max(plan.shared_bytes, part.shared_bytes);
  }
  return plan;
}

int widest(std::span<const UpdateContext> contexts, const LocalStoreDemand& demand, std::size_t size) {
  int width = widest_strip;
  while (width > 0 && local_store_bytes(contexts, demand, width) > size) width /= 2;
  return width;
}

std::string in_words(const LocalStoreDemand& demand) {
  return "skeleton \"" + demand.skeleton + "\" with schedule " +
         (demand.schedule == Schedule::fused ? "fused" : "levels") + " and stream " +
         (demand.plays_keys ? "keyframe" : "sampled");
}

Error too_small(std::span<const UpdateContext> contexts, const LocalStoreDemand& demand, std::size_t size) {
  const std::size_t needed = local_store_bytes(contexts, demand, 1), whole = (needed + kib - 1) / kib;
  return {in_words(demand) + " needs " + std::to_string(needed) + " bytes of local store for one character, not " +
          std::to_string(size) + ": the smallest that works is " + std::to_string(whole * kib) + " (--local-store " +
          std::to_string(whole) + ")"};
}

Error too_wide(const LocalStoreDemand& demand, std::size_t size, int tile, int fits) {
  return {"a tile of " + std::to_string(tile) + " characters does not fit the local store of " +
          std::to_string(size / kib) + " KiB for " + in_words(demand) + ": the largest tile that fits is " +
          std::to_string(fits) + " (--tile " + std::to_string(fits) + ")"};
}

}  // namespace

std::size_t local_store_bytes(std::span<const UpdateContext> contexts, const LocalStoreDemand& demand, int width) {
  const LocalStorePlan plan = plan_for_width(contexts, demand, width);
  return plan.all_fetch_bytes() + plan.scratch_bytes;
}

Result<LocalStorePlan> plan_local_store(std::span<const UpdateContext> contexts, const LocalStoreDemand& demand,
                                        std::size_t size, int tile) {
  const int fits = widest(contexts, demand, size);
  if (fits == 0) return too_small(contexts, demand, size);
  if (tile > fits) return too_wide(demand, size, tile, fits);
  LocalStorePlan plan = plan_for_width(contexts, demand, tile == 0 ? fits : tile);
  if (demand.schedule == Schedule::levels) return plan;
  if (tile == 0) {
    plan.strips = most_strips;
    // Of usual graphs, too, where most of the store is still left to scratch.
    if (most_strips * plan.all_fetch_bytes() <= size / 4) plan.fetch_bytes *= most_strips;
  }
  // Held strips are as wide as scratch allows, so they get the rest.
  plan.scratch_bytes = (size - plan.all_fetch_bytes()) / 64 * 64;
  return plan;
}

std::size_t automatic_local_store(std::span<const UpdateContext> contexts, const LocalStoreDemand& demand) {
  return std::max(usual_local_store_bytes, std::bit_ceil(local_store_bytes(contexts, demand, 1)));
}

bool plan_holds(const LocalStorePlan& plan, const UpdateContext& context, Schedule schedule, const StoreNeeds& needs) {
  if (schedule == Schedule::levels) return needs.entity_bytes <= plan.all_fetch_bytes();
  return needs.shared_bytes <= plan.shared_bytes && fused_fit(context, needs, needs.shared_bytes, plan).characters > 0;
}

}  // namespace throng::anim
