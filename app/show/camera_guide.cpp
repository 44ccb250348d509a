#include "app/show/camera_guide.h"

#include "app/crowd/cast.h"
#include "app/show/track_cameras.h"
#include "app/view/camera_path.h"
#include "app/view/fly_camera.h"

namespace throng::app {

std::vector<NamedCamera> cameras_of(const Stage& stage, float aspect) {
  if (const Followers* const followers = followers_of(stage.crowd())) {
    return track_cameras(*followers, static_cast<float>(stage.crowd().laid_out_for().height), aspect);
  }
  return scene_cameras(stage.tuning().scene, static_cast<std::size_t>(stage.tuning().agents),
                       common_roles(roles_of(stage.characters())), stage.tuning().clothes);
}

render::Camera CameraGuide::begin_scene(const Stage& stage) {
  start_ = camera_at(cameras_of(stage).front().place);
  return start_;
}

render::Camera CameraGuide::home(const Stage& stage) const {
  return path_ == CameraPath::none ? camera_at(cameras_of(stage).front().place) : start_;
}

bool CameraGuide::can_film(const Stage& stage) const {
  return path_ != CameraPath::none || stage.animated().cut_scene() != nullptr;
}

render::Camera CameraGuide::moved(const Stage& stage, const render::Camera& camera, bool films) {
  if (films && path_ != CameraPath::none) return along(path_, start_, anim::to_seconds(stage.system().clock()));
  if (films && stage.animated().cut_scene() != nullptr) return stage.animated().cut_scene()->film();
  return carried(stage, camera);
}

render::Camera CameraGuide::carried(const Stage& stage, const render::Camera& camera) {
  const std::optional<std::uint32_t> agent = stage.selected();
  follows_ = follows_ && agent.has_value();
  if (!follows_) {
    followed_.reset();
    return camera;
  }
  const glm::vec3 place = stage.crowd().positions()[*agent];
  render::Camera next = camera;
  if (followed_ && followed_->agent == *agent) next.position += place - followed_->place;
  followed_ = {*agent, place};
  return next;
}

}  // namespace throng::app
