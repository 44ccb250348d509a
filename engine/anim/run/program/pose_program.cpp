#include "engine/anim/run/program/pose_program.h"

#include <algorithm>
#include <string>

#include "engine/anim/run/program/program_table.h"

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
    Status visited = owned ? push_after_sources(entity) : push_shared(entity);
    --depth_;
    step = static_cast<std::uint8_t>(count_ - 1);
    return visited;
  }

  std::span<PoseStep> steps() { return {steps_.data(), count_}; }
  std::span<const Handle> entities() const { return {entities_.data(), count_}; }

 private:
  Status push_after_sources(Handle entity) {
    PoseStep step{.kind = static_cast<std::uint8_t>(entity.pool())};
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
    return push(entity, step);
  }

  Status push_shared(Handle entity) {
    const int below = highest_priority - pools_->state(entity).priority;
    return push(entity, {.shared = entity, .below_highest = static_cast<std::uint8_t>(below)});
  }

  Status push(Handle entity, const PoseStep& step) {
    if (count_ == steps_.size()) return too_large();
    if (step.below_highest >= PoseProgram::max_depth) {
      return Error{"the " + named(*pools_, entity) + " has more than " + std::to_string(PoseProgram::max_depth) +
                   " entities below it"};
    }
    entities_[count_] = entity;
    steps_[count_++] = step;
    return Done{};
  }

  static Error too_large() {
    return {"a graph of more than " + std::to_string(PoseProgram::max_steps) +
            " entities: an agent has at most that many"};
  }

  std::uint8_t find(Handle entity) const {
    const auto at = std::ranges::find(entities(), entity);
    return at == entities().end() ? no_step : static_cast<std::uint8_t>(at - entities().begin());
  }
  std::string reader() const {
    return depth_ == 0 ? "an agent" : "the " + named(*pools_, path_[static_cast<std::size_t>(depth_ - 1)]);
  }

  EntityPools* pools_;
  std::uint32_t owner_;
  std::array<PoseStep, PoseProgram::max_steps> steps_;
  std::array<Handle, PoseProgram::max_steps> entities_;
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
      if (last_reader[steps[i].sources[k]] == i && !source.layout(pools).is_resident()) {
        taken[source.target] = false;
      }
    }
    if (steps[i].layout(pools).is_resident()) continue;
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
    return !step.is_shared() && step.source_count == 1 && step.sources[0] == i - 1 && !step.layout(pools).is_resident();
  };
  std::size_t tail = steps.size();
  while (tail > 1 && changes_in_place(tail - 1)) --tail;
  std::size_t packet_tail = steps.size();
  while (packet_tail > tail && !steps[packet_tail - 1].layout(pools).kind->whole_pose()) --packet_tail;
  program.tail = static_cast<std::uint8_t>(tail);
  program.packet_tail = static_cast<std::uint8_t>(packet_tail);
  program.blocks_before_tail = 0;
  program.prepared_before_tail = 0;
  for (const PoseStep& step : steps.first(tail)) {
    if (step.is_shared()) continue;
    const EntityLayout& layout = step.layout(pools);
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

void count_step(std::span<const PoseStep> steps, std::size_t index, const EntityPools& pools, PoseProgram& program) {
  const PoseStep& step = steps[index];
  const EntityLayout& layout = step.layout(pools);
  StoreNeeds& needs = program.needs;
  if (step.is_shared()) {
    needs.shared_bytes += layout.source_bytes();
    ++needs.shared;
    return;
  }
  needs.fetch_bytes += layout.total_size;
  std::uint32_t entity_bytes = layout.total_size;
  for (std::size_t k = 0; k < step.source_count; ++k) {
    entity_bytes += steps[step.sources[k]].layout(pools).source_bytes();
  }
  needs.entity_bytes = std::max(needs.entity_bytes, entity_bytes);
  needs.prepared_bytes += static_cast<std::uint32_t>(layout.kind->prepared_bytes);
  if (layout.kind->whole_pose()) needs.hold(packets_for_bones(layout.kind->whole_bones));
  count_part(*layout.kind, program.parts);
}

}  // namespace

const PoseProgram no_program;

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

Status compile_graph(EntityPools& pools, Handle root, std::uint32_t owner, ProgramTable& programs, PoseGraph& graph) {
  Flattening flattening(pools, owner);
  std::uint8_t root_step = 0;
  if (Status visited = flattening.visit(root, root_step); !visited) return visited;
  const std::span<PoseStep> steps = flattening.steps();
  PoseProgram& program = programs.draft();
  program.needs = {.registers = assign_registers(steps, pools)};
  program.parts = {};
  find_tails(steps, pools, program);
  for (std::size_t i = 0; i < steps.size(); ++i) count_step(steps, i, pools, program);
  program.steps.assign(steps.begin(), steps.end());
  graph.program = &programs.same_as_draft();
  graph.entities.assign(flattening.entities().begin(), flattening.entities().end());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].is_shared()) continue;
    pools.state(graph.entities[i]).priority = static_cast<std::int16_t>(highest_priority - steps[i].below_highest);
  }
  return Done{};
}

}  // namespace throng::anim
