#pragma once

#include <functional>
#include <memory>

#include "engine/anim/agent/channel.h"
#include "engine/anim/agent/entity_builder.h"

namespace throng::anim {

/// Paper 2.1.2: "too often the final animation pose needs to be tweaked after it is calculated." Entities on top of
/// what the agent's channels make; several are applied in the order in which they were added. Called at frame
/// boundaries, by one thread.
class PostProcess {
 public:
  virtual ~PostProcess() = default;

  /// The entity that tweaks the pose of `source`; made by the first call, given another source by later ones. A process
  /// that has nothing to do returns the source.
  virtual Handle attach(const EntityBuilder& build, Handle source) = 0;

  /// Brings its entities up to date with its parameters. True: attach() is to be called again. Called when a parameter
  /// was set through `Agent::change_process`, and at or after next_update().
  virtual bool update(const EntityBuilder&) { return false; }
  /// When update() wants to be called again by itself: a time of the clock, or never.
  virtual Ticks next_update() const { return never; }

  virtual void visit_handles(const std::function<void(Handle&)>& visit) = 0;
  virtual void destroy_entities(const EntityBuilder& build) = 0;
  virtual std::unique_ptr<PostProcess> clone() const = 0;
};

}  // namespace throng::anim
