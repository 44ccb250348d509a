#include "engine/anim/run/tile_cutter.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>

#include "engine/anim/run/fused_scratch.h"

namespace throng::anim {
namespace {

constexpr std::size_t groups = most_skeletons * 2 * max_bone_levels;
constexpr std::size_t buckets = 32;  // two for each doubling of the cost

std::size_t group_of(const AgentWork& work) {
  return (work.skeleton * std::size_t{2} + (work.held ? 0U : 1U)) * max_bone_levels + work.level;
}

// 0: the dearest.
std::size_t bucket_of(std::uint16_t cost) {
  const auto width = static_cast<std::size_t>(std::bit_width(std::max<std::uint16_t>(cost, 1)));
  const std::size_t half = width < 2 ? 0 : std::size_t{cost} >> (width - 2) & 1U;
  return buckets - 1 - (2 * (width - 1) + half);
}

std::size_t class_of(const AgentWork& work) { return group_of(work) * buckets + bucket_of(work.cost); }

using ClassStarts = std::array<std::uint32_t, groups * buckets>;

/// Where each class begins, groups of the dearest agents first.
void place_classes(const std::array<std::uint64_t, groups>& costs, const std::array<std::uint32_t, groups>& counts,
                   ClassStarts& sizes_then_starts) {
  std::array<std::uint16_t, groups> order;
  std::size_t count = 0;
  for (std::size_t group = 0; group < groups; ++group) {
    if (counts[group] > 0) order[count++] = static_cast<std::uint16_t>(group);
  }
  std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), [&](std::size_t a, std::size_t b) {
    const std::uint64_t left = costs[a] * counts[b], right = costs[b] * counts[a];  // mean costs, without dividing
    return left != right ? left > right : a < b;
  });
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
      std::uint32_t& start = sizes_then_starts[order[i] * buckets + bucket];
      const std::uint32_t size = start;
      start = next;
      next += size;
    }
  }
}

bool share_a_tile(const AgentWork& a, const AgentWork& b) {
  return a.skeleton == b.skeleton && a.level == b.level && a.held == b.held;
}

bool is_one_class(std::span<const AgentWork> work) {
  return std::ranges::all_of(work, [&first = work.front()](const AgentWork& agent) {
    return share_a_tile(first, agent) && (agent.cost == first.cost || bucket_of(agent.cost) == bucket_of(first.cost));
  });
}

/// Room for `needs` is room for `other`, too.
bool hold(const StoreNeeds& needs, const StoreNeeds& other) {
  StoreNeeds wider = needs;
  wider.widen(other);
  return wider == needs;
}

/// The widest tile of agents of these needs.
int tile_limit(const UpdateContext& context, const StoreNeeds& needs, const SharedSources& shared,
               const LocalStorePlan& plan, Schedule schedule) {
  if (schedule == Schedule::levels) return plan.width;
  return std::min(plan.width, widest_fused_tile(context, needs, shared.bytes(*context.pools), plan));
}

}  // namespace

void TileCutter::reserve(std::size_t agents) {
  sorted_.reserve(agents);
  tiles_.reserve(agents);
}

// A stable counting sort. A crowd of one class, which is common, stays where it is.
std::span<const AgentWork> TileCutter::sorted(std::span<const AgentWork> work) {
  if (work.empty() || is_one_class(work)) return work;
  ClassStarts places{};
  std::array<std::uint64_t, groups> costs{};
  std::array<std::uint32_t, groups> counts{};
  for (const AgentWork& agent : work) {
    ++places[class_of(agent)];
    costs[group_of(agent)] += agent.cost;
    ++counts[group_of(agent)];
  }
  place_classes(costs, counts, places);
  sorted_.resize(work.size());
  for (const AgentWork& agent : work) sorted_[places[class_of(agent)]++] = agent;
  return sorted_;
}

void TileCutter::cut_full_width(std::span<const UpdateContext> contexts, std::span<const AgentWork> work,
                                const LocalStorePlan& plan, Schedule schedule) {
  tiles_.clear();
  StoreNeeds needs;  // of the last tile
  SharedSources shared;
  int limit = 0;  // characters of these needs in a tile
  for (std::uint32_t i = 0; i < work.size(); ++i) {
    const UpdateContext& context = contexts[work[i].skeleton];
    const PoseProgram& program = *work[i].program;
    const bool joins = i > 0 && share_a_tile(work[i - 1], work[i]);
    const bool as_before = joins && work[i - 1].program == &program;  // as nearly always
    if (joins && program.needs.shared == 0 && (as_before || hold(needs, program.needs))) {
      if (tiles_.back().count == static_cast<std::uint32_t>(limit)) tiles_.push_back({.first = i, .needs = needs});
      ++tiles_.back().count;
      continue;
    }
    StoreNeeds wider = needs;
    wider.widen(program.needs);
    SharedSources more = shared;
    const int wider_limit = joins && more.add(program) ? tile_limit(context, wider, more, plan, schedule) : 0;
    if (joins && wider_limit > static_cast<int>(tiles_.back().count)) {
      ++tiles_.back().count;
      tiles_.back().needs = needs = wider;
      shared = more;
      limit = wider_limit;
      continue;
    }
    needs = program.needs;
    tiles_.push_back({.first = i, .count = 1, .needs = needs});
    shared = SharedSources(work.subspan(i, 1));
    limit = tile_limit(context, needs, shared, plan, schedule);
    assert(limit > 0 && "a program that does not fit the local store was let in");
  }
}

// The sum of all.
double TileCutter::add_costs(std::span<const UpdateContext> contexts, std::span<const AgentWork> work,
                             const CostModel& cost) {
  double total = 0;
  for (Tile& tile : tiles_) {
    std::uint64_t steps = 0;
    for (const AgentWork& agent : work.subspan(tile.first, tile.count)) steps += agent.cost;
    const double agents = static_cast<double>(steps) * cost_step;
    const AgentWork& first = work[tile.first];
    tile.cost = static_cast<float>(cost.of_tile(contexts[first.skeleton].packets(first.level)) + agents);
    total += static_cast<double>(tile.cost);
  }
  return total;
}

// In two, so that the first costs about `wanted`; both keep the overhead of a tile.
void TileCutter::divide(std::size_t tile, double wanted, double overhead) {
  Tile& left = tiles_[tile];
  const double agent = (static_cast<double>(left.cost) - overhead) / left.count;
  const double fits = (wanted - overhead) / agent;
  const auto kept = static_cast<std::uint32_t>(std::clamp(fits + 0.5, 1.0, static_cast<double>(left.count) - 1));
  const std::uint32_t moved = left.count - kept;
  const Tile right{.first = left.first + kept,
                   .count = moved,
                   .cost = static_cast<float>(overhead + moved * agent),
                   .needs = left.needs};
  left.count = kept;
  left.cost = static_cast<float>(overhead + kept * agent);
  tiles_.insert(tiles_.begin() + static_cast<std::ptrdiff_t>(tile) + 1, right);
}

std::span<const Tile> TileCutter::cut(std::span<const UpdateContext> contexts, std::span<const AgentWork> work,
                                      const LocalStorePlan& plan, Schedule schedule, const CostModel& cost,
                                      std::span<int> shares) {
  cut_full_width(contexts, work, plan, schedule);
  const double total = add_costs(contexts, work, cost);
  const auto share_count = shares.size() - 1;
  const double share_cost = total / static_cast<double>(share_count);
  double before = 0;
  std::size_t share = 1;
  for (std::size_t tile = 0; tile < tiles_.size() && share < share_count; ++tile) {
    const double wanted = share_cost * static_cast<double>(share) - before;
    const auto whole = static_cast<double>(tiles_[tile].cost);
    if (wanted > whole) {
      before += whole;
      continue;
    }
    ++share;
    const AgentWork& first = work[tiles_[tile].first];
    const double overhead = cost.of_tile(contexts[first.skeleton].packets(first.level));
    if (tiles_[tile].count > 1 && std::min(wanted, whole - wanted) > overhead) divide(tile, wanted, overhead);
    before += static_cast<double>(tiles_[tile].cost);
  }
  cut_shares(
      static_cast<int>(tiles_.size()),
      [this](int tile) { return static_cast<double>(tiles_[static_cast<std::size_t>(tile)].cost); }, shares);
  return tiles_;
}

int pus_worth_waking(double nanoseconds, int pus, const CostModel& cost) {
  return std::clamp(static_cast<int>(std::min(nanoseconds / cost.least_task, 1e6)), 1, pus);
}

}  // namespace throng::anim
