#pragma once

#include <functional>
#include <memory>

#include "engine/anim/agent/entity_builder.h"

namespace throng::anim {

/// Paper 2.1.2: "too often the final animation pose needs to be tweaked after it is calculated." One entity on top of
/// what the agent's channels make; several are applied in the order in which they were added.
class PostProcess {
 public:
  virtual ~PostProcess() = default;

  /// The entity that tweaks the pose of `source`; made by the first call, given another source by later ones.
  virtual Handle attach(const EntityBuilder& build, Handle source) = 0;

  virtual void visit_handles(const std::function<void(Handle&)>& visit) = 0;
  virtual void destroy_entities(const EntityBuilder& build) = 0;
  virtual std::unique_ptr<PostProcess> clone() const = 0;
};

}  // namespace throng::anim
