#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "app/show/stage/lent_processes.h"
#include "engine/anim/agent/targeted_processes.h"

namespace throng::app {

/// Heads that turn to a person. An agent has the post process while it looks at a person near by, and until its head is
/// back, so its gaze follows from the last request.
class Gazes : public LentProcesses<anim::LookAtProcess> {
 public:
  /// Takes RigKinds::look_at of each character; it is empty for a character without a gaze. `system` outlives this.
  using LentProcesses::LentProcesses;

  /// Turns the head of an agent towards a place in its model space, by a share of the way. Call it before an update of
  /// the agent with all bones, for the pose of now.
  void look(std::uint32_t agent, const glm::vec3& target, float share);
  /// Lets an agent look where its clips do. Call it before the update.
  void look_away(std::uint32_t agent);
};

}  // namespace throng::app
