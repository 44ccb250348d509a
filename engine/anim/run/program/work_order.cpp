#include "engine/anim/run/program/work_order.h"

#include <algorithm>
#include <array>
#include <bit>

#include "engine/anim/base/room.h"

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

/// Finds where each class begins; groups of the dearest agents come first.
void find_class_starts(const std::array<std::uint64_t, groups>& costs, const std::array<std::uint32_t, groups>& counts,
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

bool continue_a_run(const AgentWork& a, const AgentWork& b) {
  return a.program == b.program && a.cost == b.cost && share_a_tile(a, b);
}

}  // namespace

void find_runs(std::span<const AgentWork> work, std::vector<WorkRun>& runs) {
  runs.clear();
  const auto count = static_cast<std::uint32_t>(work.size());
  for (std::uint32_t first = 0, end = 0; first < count; first = end) {
    for (end = first + 1; end < count && continue_a_run(work[first], work[end]);) ++end;
    runs.push_back({first, end - first});
  }
}

void WorkOrder::reserve(std::size_t agents) {
  make_room(sorted_, agents);
  make_room(sorted_runs_, agents);
}

// A stable counting sort.
void WorkOrder::sort(const WorkInRuns& given) {
  ordered_ = given;
  if (is_in_order()) return;
  ClassStarts starts{};
  std::array<std::uint64_t, groups> costs{};
  std::array<std::uint32_t, groups> counts{};
  for (const WorkRun& run : given.runs) {
    const AgentWork& like = given.work[run.first];
    starts[class_of(like)] += run.count;
    costs[group_of(like)] += std::uint64_t{run.count} * like.cost;
    counts[group_of(like)] += run.count;
  }
  find_class_starts(costs, counts, starts);
  sorted_.resize(given.work.size());
  for (const WorkRun& run : given.runs) {
    std::uint32_t& next = starts[class_of(given.work[run.first])];
    std::ranges::copy(given.work.subspan(run.first, run.count), sorted_.begin() + next);
    next += run.count;
  }
  find_runs(sorted_, sorted_runs_);
  ordered_ = {sorted_, sorted_runs_};
}

/// Returns true if all work is of one class.
bool WorkOrder::is_in_order() const {
  if (runs().empty()) return true;
  return std::ranges::all_of(runs(), [this, first = class_of(work().front())](const WorkRun& run) {
    return class_of(work()[run.first]) == first;
  });
}

double WorkOrder::predicted() const {
  std::uint64_t steps = 0;
  for (const WorkRun& run : runs()) steps += std::uint64_t{run.count} * work()[run.first].cost;
  return static_cast<double>(steps) * cost_step;
}

}  // namespace throng::anim
