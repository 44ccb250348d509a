#pragma once

#include <functional>
#include <limits>
#include <memory>

#include "engine/anim/agent/entity_builder.h"

namespace throng::anim {

inline constexpr Ticks never = std::numeric_limits<Ticks>::max();

/// Paper 2.1.2: "a channel produces ultimately an animation state. [...] Animation channel is an abstract interface and
/// can be specialized through derivation." It owns the entities that its state is made of, and stores the parameters
/// that shape it. One thread calls it, at frame boundaries.
///
/// Derive from it, make entities in update() with the builder, and say by state() which of them is the result.
class Channel {
 public:
  virtual ~Channel() = default;

  /// Returns why the channel cannot play this character, in one sentence that lives as long as the program; null if it
  /// can. A channel with a fault is not added.
  virtual const char* fault(const EntityBuilder&) const { return nullptr; }

  /// Returns the entity whose pose is the channel's; invalid until there is one.
  virtual Handle state() const = 0;

  /// Takes the pose that the channel will be laid over, before a call of state(); it is invalid where there is none.
  virtual void lie_over(const EntityBuilder&, Handle) {}

  /// Brings the channel's entities up to date with its parameters and the clock. Returns whether state(), or an entity
  /// that it reads, is another than before. It is called when a parameter was set through `Agent::change`, and at or
  /// after next_update().
  virtual bool update(const EntityBuilder& build) = 0;

  /// Does what update() does if that makes, destroys and connects no entity; else does nothing, and returns false.
  /// Threads call it at once, each for another agent.
  virtual bool update_in_place(const EntityBuilder&) { return false; }

  /// Returns the time of the clock at which update() must be called again by itself, or never.
  virtual Ticks next_update() const { return never; }

  /// Ends at once a fade that the channel began by itself, because the agent's graph has no room for both sides.
  virtual void cut_fades(const EntityBuilder&) {}

  /// Calls `visit` with each handle that the channel keeps, because entities are renamed when the stream changes.
  virtual void visit_handles(const std::function<void(Handle&)>& visit) = 0;

  /// Gives every entity that the channel made back to its pool.
  virtual void destroy_entities(const EntityBuilder& build) = 0;

  /// Returns a copy that names the same entities, for snapshots.
  virtual std::unique_ptr<Channel> clone() const = 0;
};

}  // namespace throng::anim
