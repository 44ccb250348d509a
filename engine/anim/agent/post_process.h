#pragma once

#include <functional>
#include <memory>

#include "engine/anim/agent/channel.h"
#include "engine/anim/agent/entity_builder.h"

namespace throng::anim {

/// Paper 2.1.2: "too often the final animation pose needs to be tweaked after it is calculated." A post process has
/// entities on top of what the agent's channels make. Several processes work in the order in which they were added. One
/// thread calls it, at frame boundaries.
class PostProcess {
 public:
  virtual ~PostProcess() = default;

  /// Returns why the process cannot work on this character, in one sentence that lives as long as the program; null if
  /// it can. A process with a fault is not added.
  virtual const char* fault(const EntityBuilder&) const { return nullptr; }

  /// Returns the entity that tweaks the pose of `source`. The first call makes it, and later calls give it another
  /// source. A process that has nothing to do returns the source.
  virtual Handle attach(const EntityBuilder& build, Handle source) = 0;

  /// Brings its entities up to date with its parameters. Returns whether attach() must be called again. It is called
  /// when a parameter was set through `Agent::change_process`, and at or after next_update().
  virtual bool update(const EntityBuilder&) { return false; }
  /// Does what update() does if that makes, destroys and connects no entity; else does nothing, and returns false.
  /// Threads call it at once, each for another agent.
  virtual bool update_in_place(const EntityBuilder&) { return false; }
  /// Returns the time of the clock at which update() must be called again by itself, or never.
  virtual Ticks next_update() const { return never; }

  virtual void visit_handles(const std::function<void(Handle&)>& visit) = 0;
  virtual void destroy_entities(const EntityBuilder& build) = 0;
  virtual std::unique_ptr<PostProcess> clone() const = 0;
};

}  // namespace throng::anim
