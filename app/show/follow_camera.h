#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <glm/vec3.hpp>

#include "throng/render/camera.h"
#include "throng/ticks.h"

#include "engine/base/result.h"

namespace throng::app {

class Stage;

/// A camera behind and above an agent. It goes where the agent goes and turns with the agent lazily. A person who moves
/// it by hand goes on from there. It waits at the agent's first row, and stays at the last one.
class FollowCamera {
 public:
  /// Follows an agent.
  explicit FollowCamera(std::uint32_t agent) : agent_(agent) {}
  /// Follows the agent that has this id in a live crowd, whatever its number is.
  explicit FollowCamera(std::string id) : id_(std::move(id)) {}

  /// Returns the camera of the moment on the stage. `camera` is the camera of the frame before, or one that waits for
  /// the agent to come. Call it once a frame.
  render::Camera moved(const Stage& stage, const render::Camera& camera);
  /// Returns the followed agent; nothing while no agent of a live crowd has the id.
  const std::optional<std::uint32_t>& agent() const { return agent_; }

 private:
  /// The place of an agent, and which way it looks: radians from +Z towards +X.
  struct Pose {
    glm::vec3 place{0.0F};
    float heading = 0.0F;
  };
  static std::optional<Pose> pose_of(const Stage& stage, std::uint32_t agent);
  render::Camera behind(const Stage& stage, const Pose& pose) const;
  void find_by_id(const Stage& stage);

  std::optional<std::uint32_t> agent_;
  std::string id_;  // empty: agent_ stays the same
  std::optional<Pose> pose_;
  Ticks clock_{};
};

/// Returns a camera that follows the agent of this name: the id that a recorded crowd has, or #N, the agent N of any
/// crowd. Errors: no agent has the name.
Result<FollowCamera> follow_camera(const Stage& stage, const std::string& name);

/// Returns the name that follow_camera() finds this agent by.
std::string follow_name(const Stage& stage, std::uint32_t agent);

}  // namespace throng::app
