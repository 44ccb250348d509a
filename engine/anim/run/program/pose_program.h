#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/anim/entity/entity_pools.h"
#include "engine/anim/run/program/cost_model.h"
#include "engine/base/result.h"

namespace throng::anim {

/// One entity of a graph.
///
///      0        4      5          6        7         8
///     | shared | kind | priority | target | sources | which steps its sources are, 8 |   16 bytes
struct PoseStep {
  Handle shared{};                 ///< another owner's entity, read-only, updated before all agents; invalid: its own
  std::uint8_t kind = 0;           ///< EntityPools::Kind of its own entity
  std::uint8_t below_highest = 0;  ///< highest_priority - the entity's priority: 0 for players (paper 2.2.5)
  std::uint8_t target = 0;         ///< the pose register that it writes, if its block has no transforms
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
  std::uint32_t fetch_bytes = 0;     ///< bytes of its own blocks
  std::uint32_t shared_bytes = 0;    ///< bytes of others' blocks, once a tile
  std::uint32_t entity_bytes = 0;    ///< the most that one entity and its sources take, for `levels`
  std::uint32_t prepared_bytes = 0;  ///< EntityKind::prepared_bytes of all its entities
  std::uint8_t registers = 1;        ///< the number of poses that live at once
  std::uint8_t shared = 0;           ///< the number of others' blocks that it reads
  bool held = false;                 ///< some entity needs bones of several packets, so these are kept
  std::uint8_t held_packets = 0;     ///< the number of packets that are kept; may be more than there are

  void hold(std::uint8_t packets);
  void widen(const StoreNeeds& other);
  friend bool operator==(const StoreNeeds&, const StoreNeeds&) = default;
};

/// A graph of entities, flattened. It has each entity once, after its sources, and the root last, so that a source that
/// several entities read is evaluated once. The graph may have any shape without cycles, up to the limits below. The
/// program does not name the owner of the entities: all agents of a skeleton whose graphs look alike run one program
/// (program_table.h).
struct PoseProgram {
  static constexpr std::size_t max_steps = 64;
  /// The most steps below the highest priority, by way of shared entities too.
  static constexpr std::size_t max_depth = 128;

  std::vector<PoseStep> steps;
  /// The first step of the tail. Each step of the tail reads the step before it alone, and is the only reader of that
  /// step, so a pose is changed where it lies. The tail never begins with the first step of the program.
  std::uint8_t tail = 1;
  std::uint8_t packet_tail = 1;            ///< the first step of the part of the tail that works packet by packet
  std::uint32_t blocks_before_tail = 0;    ///< bytes of its own blocks before the tail
  std::uint32_t prepared_before_tail = 0;  ///< bytes that are prepared for these blocks
  StoreNeeds needs;
  ProgramParts parts;  ///< its own parts; shared parts are paid for once a frame

  friend bool operator==(const PoseProgram&, const PoseProgram&) = default;
};

/// The program of agents that play nothing.
extern const PoseProgram no_program;

class ProgramTable;

/// An agent's graph: a program and the entities that it runs over.
struct PoseGraph {
  const PoseProgram* program = &no_program;  ///< never null; a program of the table, which outlives the graph
  std::vector<Handle> entities;              ///< [step]

  Handle root() const { return entities.back(); }
  bool empty() const { return entities.empty(); }
  void clear() {
    program = &no_program;
    entities.clear();
  }
};
static_assert(sizeof(PoseGraph) == 4 * sizeof(void*), "what a frame reads of every agent");

/// The bit that owners of graphs of shared entities have. Owners without it are agents.
inline constexpr std::uint32_t shared_owner = 1U << 31;

/// Flattens the graph below `root`. Gives each entity of `owner` its priority: the lowest of its sources' minus one;
/// players have the highest. Shared entities of another owner are read as they are. Reuses the graph's memory. Errors:
/// a handle to nothing, a cycle, an entity of another owner that is not shared, an entity that reads more than
/// max_sources, more than max_steps entities, or more than max_depth below each other; then the graph is as it was.
Status compile_graph(EntityPools& pools, Handle root, std::uint32_t owner, ProgramTable& programs, PoseGraph& graph);

}  // namespace throng::anim
