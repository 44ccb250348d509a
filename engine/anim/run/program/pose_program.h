#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/anim/base/result.h"
#include "engine/anim/entity/entity_pools.h"
#include "engine/anim/run/program/cost_model.h"

namespace throng::anim {

/// One entity of a graph.
///
///      0        4      5          6        7         8
///     | shared | kind | priority | target | sources | which steps its sources are, 8 |   16 bytes
struct PoseStep {
  Handle shared{};                 ///< of another owner, read-only here: updated before all agents; invalid: its own
  std::uint8_t kind = 0;           ///< EntityPools::Kind of its own entity
  std::uint8_t below_highest = 0;  ///< highest_priority - the entity's priority: 0 for players (paper 2.2.5)
  std::uint8_t target = 0;         ///< pose register that it writes, if its block has no transforms
  std::uint8_t source_count = 0;
  std::array<std::uint8_t, max_sources> sources{};  ///< steps before this one

  bool is_shared() const { return shared.valid(); }
  const EntityLayout& layout(const EntityPools& pools) const {
    return is_shared() ? pools.layout(shared) : pools.layout(EntityPools::Kind{kind});
  }
  friend bool operator==(const PoseStep&, const PoseStep&) = default;
};
static_assert(sizeof(PoseStep) == 16);

/// The room that a program needs in the local store.
struct StoreNeeds {
  std::uint32_t fetch_bytes = 0;     ///< blocks of its own
  std::uint32_t shared_bytes = 0;    ///< of others, once a tile
  std::uint32_t entity_bytes = 0;    ///< the most that one entity and its sources take, for `levels`
  std::uint32_t prepared_bytes = 0;  ///< of all kinds
  std::uint8_t registers = 1;        ///< poses that live at once
  std::uint8_t shared = 0;           ///< blocks of others that it reads
  bool held = false;                 ///< some entity needs bones of several packets, so these are kept
  std::uint8_t held_packets = 0;     ///< that are kept, from the first on; may be more than there are

  void hold(std::uint8_t packets);
  void widen(const StoreNeeds& other);
  friend bool operator==(const StoreNeeds&, const StoreNeeds&) = default;
};

/// A graph of entities, flattened: each entity once, after its sources, the root last, so that a source that several
/// entities read is evaluated once. Any shape and depth without cycles. Whose entities they are it does not say: all
/// agents of a skeleton whose graphs look alike run one program (program_table.h).
struct PoseProgram {
  static constexpr std::size_t max_steps = 64;
  /// Steps below the highest priority, by way of shared entities too.
  static constexpr std::size_t max_depth = 128;

  std::vector<PoseStep> steps;
  /// From here on each step reads the one before it and nothing else, and nobody else reads that one: a pose is changed
  /// where it lies. Never the first step.
  std::uint8_t tail = 1;
  std::uint8_t packet_tail = 1;            ///< from here on, none below `tail`, they do so packet by packet
  std::uint32_t blocks_before_tail = 0;    ///< bytes of its own blocks
  std::uint32_t prepared_before_tail = 0;  ///< and of what is prepared for them
  StoreNeeds needs;
  ProgramParts parts;  ///< of its own; shared ones are paid for once a frame

  friend bool operator==(const PoseProgram&, const PoseProgram&) = default;
};

/// The program of agents that play nothing.
extern const PoseProgram no_program;

class ProgramTable;

/// An agent's graph: a program and the entities that it runs over.
struct PoseGraph {
  const PoseProgram* program = &no_program;  ///< never null; of the table, which outlives the graph
  std::vector<Handle> entities;              ///< [step]

  Handle root() const { return entities.back(); }
  bool empty() const { return entities.empty(); }
  void clear() {
    program = &no_program;
    entities.clear();
  }
};
static_assert(sizeof(PoseGraph) == 32, "what a frame reads of every agent");

/// Owners of graphs of shared entities have this bit; others are agents.
inline constexpr std::uint32_t shared_owner = 1U << 31;

/// Flattens what `root` reads and gives each entity of `owner` its priority: the lowest of its sources' minus one,
/// players highest. Shared entities of another owner are read as they are. Reuses the graph's memory. Errors, and
/// then the graph is as it was: a handle to nothing, a cycle, an entity of another owner that is not shared, one
/// that reads more than max_sources, more than max_steps entities or max_depth below each other.
Status compile_graph(EntityPools& pools, Handle root, std::uint32_t owner, ProgramTable& programs, PoseGraph& graph);

}  // namespace throng::anim
