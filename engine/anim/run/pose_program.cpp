#include "engine/anim/run/pose_program.h"

#include <algorithm>
#include <bit>
#include <string>

namespace throng::anim {
namespace {

constexpr std::uint8_t no_step = UINT8_MAX;
constexpr int most_held_packets = UINT8_MAX;

std::string named(const EntityPools& pools, Handle entity) {
  return std::string(pools.kind(entity).name) + " " + std::to_string(entity.index());
}

/// Depth first, sources in their order.
class Flattening {
 public:
  Flattening(EntityPools& pools, std::uint32_t owner) : pools_(&pools), owner_(owner) {}

  Status visit(Handle entity, std::uint8_t& step) {
    if (!pools_->alive(entity)) return Error{reader() + " is to read an entity that does not exist"};
    const bool owned = pools_->state(entity).owner == owner_;
    if (!owned && !EntityPools::is_shared(entity)) {
      return Error{reader() + " is to read the " + named(*pools_, entity) +
                   ", which belongs to another agent: create it as shared"};
    }
    step = find(entity);
    if (step != no_step) return Done{};
    if (std::ranges::find(path_.begin(), path_.begin() + depth_, entity) != path_.begin() + depth_) {
      return Error{"the " + named(*pools_, entity) + " is among its own sources: a graph of entities has no cycles"};
    }
    if (depth_ == static_cast<std::ptrdiff_t>(path_.size())) return too_large();
    path_[static_cast<std::size_t>(depth_++)] = entity;
    const Status visited = owned ? push_after_sources(entity) : push_shared(entity);
    --depth_;
    step = static_cast<std::uint8_t>(count_ - 1);
    return visited;
  }

  std::span<PoseStep> steps() { return {steps_.data(), count_}; }

 private:
  Status push_after_sources(Handle entity) {
    PoseStep step{.entity = entity};
    const std::span<const Handle> sources = pools_->sources(entity);
    if (sources.size() > max_sources) {
      return Error{"the " + named(*pools_, entity) + " reads more than " + std::to_string(max_sources) + " sources"};
    }
    for (const Handle source : sources) {
      std::uint8_t at = no_step;
      if (Status visited = visit(source, at); !visited) return visited;
      step.sources[step.source_count++] = at;
      const auto below = static_cast<std::uint8_t>(steps_[at].below_highest + 1);
      step.below_highest = std::max(step.below_highest, below);
    }
    return push(step);
  }

  Status push_shared(Handle entity) {
    const int below = highest_priority - pools_->state(entity).priority;
    return push({.entity = entity, .below_highest = static_cast<std::uint8_t>(below), .shared = true});
  }

  Status push(const PoseStep& step) {
    if (count_ == steps_.size()) return too_large();
    if (step.below_highest >= PoseProgram::max_depth) {
      return Error{"the " + named(*pools_, step.entity) + " has more than " + std::to_string(PoseProgram::max_depth) +
                   " entities below it"};
    }
    steps_[count_++] = step;
    return Done{};
  }

  static Error too_large() {
    return {"a graph of more than " + std::to_string(PoseProgram::max_steps) +
            " entities: an agent has at most that many"};
  }

  std::uint8_t find(Handle entity) const {
    const auto* const end = steps_.data() + count_;
    const auto* const at =
        std::find_if(steps_.data(), end, [&](const PoseStep& step) { return step.entity == entity; });
    return at == end ? no_step : static_cast<std::uint8_t>(at - steps_.data());
  }
  std::string reader() const {
    return depth_ == 0 ? "an agent" : "the " + named(*pools_, path_[static_cast<std::size_t>(depth_ - 1)]);
  }

  EntityPools* pools_;
  std::uint32_t owner_;
  std::array<PoseStep, PoseProgram::max_steps> steps_;
  std::size_t count_ = 0;
  std::array<Handle, PoseProgram::max_steps> path_;  // from the root to where we are
  std::ptrdiff_t depth_ = 0;
};

/// Registers are given back after their last reader; a step may write over the source that it reads last.
std::uint8_t assign_registers(std::span<PoseStep> steps, const EntityPools& pools) {
  std::array<std::uint8_t, PoseProgram::max_steps> last_reader{};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    for (std::size_t k = 0; k < steps[i].source_count; ++k)
      last_reader[steps[i].sources[k]] = static_cast<std::uint8_t>(i);
  }
  std::array<bool, PoseProgram::max_steps> taken{};
  std::size_t count = 1;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    for (std::size_t k = 0; k < steps[i].source_count; ++k) {
      const PoseStep& source = steps[steps[i].sources[k]];
      if (last_reader[steps[i].sources[k]] == i && pools.layout(source.entity).transforms_offset == 0) {
        taken[source.target] = false;
      }
    }
    if (pools.layout(steps[i].entity).transforms_offset != 0) continue;
    const auto free = static_cast<std::size_t>(std::ranges::find(taken, false) - taken.begin());
    taken[free] = true;
    steps[i].target = static_cast<std::uint8_t>(free);
    count = std::max(count, free + 1);
  }
  return static_cast<std::uint8_t>(count);
}

void find_tails(std::span<const PoseStep> steps, const EntityPools& pools, PoseProgram& program) {
  const auto changes_in_place = [&](std::size_t i) {
    const PoseStep& step = steps[i];
    return !step.shared && step.source_count == 1 && step.sources[0] == i - 1 &&
           pools.layout(step.entity).transforms_offset == 0;
  };
  std::size_t tail = steps.size();
  while (tail > 1 && changes_in_place(tail - 1)) --tail;
  std::size_t packet_tail = steps.size();
  while (packet_tail > tail && !pools.kind(steps[packet_tail - 1].entity).whole_pose()) --packet_tail;
  program.tail = static_cast<std::uint8_t>(tail);
  program.packet_tail = static_cast<std::uint8_t>(packet_tail);
  program.blocks_before_tail = 0;
  program.prepared_before_tail = 0;
  for (const PoseStep& step : steps.first(tail)) {
    if (step.shared) continue;
    const EntityLayout& layout = pools.layout(step.entity);
    program.blocks_before_tail += layout.total_size;
    program.prepared_before_tail += static_cast<std::uint32_t>(layout.kind->prepared_bytes);
  }
}

std::uint8_t packets_for_bones(int bones) {
  return static_cast<std::uint8_t>(packets_for(std::min(bones, most_held_packets * packet_bones)));
}

void count_part(const EntityKind& kind, ProgramParts& parts) {
  if (kind.sources == nullptr) {
    ++parts.players;
  } else if (kind.whole_pose()) {
    parts.whole_pose_work = static_cast<std::uint16_t>(parts.whole_pose_work + kind.whole_pose_work);
  } else {
    ++parts.blenders;
  }
}

/// See PoseProgram::shape. A source is written in as many bits as the steps before its reader need.
std::uint64_t shape_of(std::span<const PoseStep> steps) {
  constexpr int pool_bits = 4, count_bits = 4;
  static_assert(EntityPools::most_kinds <= 1U << pool_bits && max_sources < 1U << count_bits);
  std::uint64_t shape = 1;  // so that leading zeros count
  int bits = 1;
  const auto write = [&](std::uint64_t value, int width) {
    shape = shape << width | value;
    bits += width;
  };
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].shared) return 0;
    const auto source_bits = static_cast<int>(std::bit_width(i));
    write(steps[i].entity.pool(), pool_bits);
    write(steps[i].source_count, count_bits);
    for (std::size_t k = 0; k < steps[i].source_count; ++k) write(steps[i].sources[k], source_bits);
  }
  return bits > 64 ? 0 : shape;
}

bool are_alike(const PoseStep& a, const PoseStep& b) {
  if (a.shared || b.shared) return a.entity == b.entity;
  return a.entity.pool() == b.entity.pool() && a.source_count == b.source_count && a.sources == b.sources;
}

}  // namespace

bool are_alike_step_by_step(const PoseProgram& a, const PoseProgram& b) {
  return std::ranges::equal(a.steps, b.steps, [](const auto& one, const auto& other) { return are_alike(one, other); });
}

void StoreNeeds::hold(std::uint8_t packets) {
  held = true;
  held_packets = std::max(held_packets, packets);
}

void StoreNeeds::widen(const StoreNeeds& other) {
  fetch_bytes = std::max(fetch_bytes, other.fetch_bytes);
  shared_bytes = std::max(shared_bytes, other.shared_bytes);
  entity_bytes = std::max(entity_bytes, other.entity_bytes);
  prepared_bytes = std::max(prepared_bytes, other.prepared_bytes);
  registers = std::max(registers, other.registers);
  shared = std::max(shared, other.shared);
  held = held || other.held;
  held_packets = std::max(held_packets, other.held_packets);
}

Status compile_program(EntityPools& pools, Handle root, std::uint32_t owner, PoseProgram& program) {
  Flattening flattening(pools, owner);
  std::uint8_t root_step = 0;
  if (Status visited = flattening.visit(root, root_step); !visited) return visited;
  const std::span<PoseStep> steps = flattening.steps();
  program.needs = {.registers = assign_registers(steps, pools)};
  find_tails(steps, pools, program);
  program.parts = {};
  for (const PoseStep& step : steps) {
    const EntityLayout& layout = pools.layout(step.entity);
    if (step.shared) {
      program.needs.shared_bytes += layout.source_bytes();
      ++program.needs.shared;
      continue;
    }
    program.needs.fetch_bytes += layout.total_size;
    std::uint32_t entity_bytes = layout.total_size;
    for (std::size_t k = 0; k < step.source_count; ++k) {
      entity_bytes += pools.layout(steps[step.sources[k]].entity).source_bytes();
    }
    program.needs.entity_bytes = std::max(program.needs.entity_bytes, entity_bytes);
    program.needs.prepared_bytes += static_cast<std::uint32_t>(layout.kind->prepared_bytes);
    if (layout.kind->whole_pose()) program.needs.hold(packets_for_bones(layout.kind->whole_bones));
    count_part(*layout.kind, program.parts);
    pools.state(step.entity).priority = static_cast<std::int16_t>(highest_priority - step.below_highest);
  }
  program.shape = shape_of(steps);
  program.steps.assign(steps.begin(), steps.end());
  return Done{};
}

}  // namespace throng::anim
