#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <glm/vec3.hpp>

#include "app/stage/stage.h"
#include "engine/render/camera.h"

namespace throng::app {

/// A camera behind and above somebody. It goes where the person goes and turns with them lazily. Who moves it by hand
/// goes on from there. It waits where somebody's first row is, and stays where the last one was.
class FollowCamera {
 public:
  /// Follows an agent.
  explicit FollowCamera(std::uint32_t agent) : agent_(agent) {}
  /// Follows whoever has this id in a live crowd, in whichever place.
  explicit FollowCamera(std::string id) : id_(std::move(id)) {}

  /// Returns the camera of the moment on the stage. `camera` is that of the frame before, or one that waits for
  /// somebody to come. Call it once a frame.
  render::Camera moved(const Stage& stage, const render::Camera& camera);
  /// Returns who is followed; nothing while nobody of a live crowd has the id.
  const std::optional<std::uint32_t>& agent() const { return agent_; }

 private:
  /// The place of somebody, and which way they look: radians from +Z towards +X.
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
  anim::Ticks clock_{};
};

/// Returns a camera that follows whom a person names: the id that a recorded crowd has, or #N, the agent N of any
/// crowd. Errors: nobody is called so.
anim::Result<FollowCamera> follow_camera(const Stage& stage, const std::string& name);

}  // namespace throng::app
