#include "app/show/camera_guide.h"

#include <cmath>
#include <utility>

#include <glm/common.hpp>

#include "app/people/crowd/cast.h"
#include "app/settings/choices.h"
#include "app/show/camera/fly_camera.h"
#include "app/show/stage/stage.h"
#include "app/show/track_cameras.h"

namespace throng::app {
namespace {

bool is_live(const Stage& stage) {
  const FollowedTracks* const tracks = stage.crowd().tracks();
  return tracks != nullptr && tracks->people().trajectories().is_live;
}

}  // namespace

std::vector<NamedCamera> cameras_of(const Stage& stage, float aspect, const PicturePart& part) {
  if (const FollowedTracks* const tracks = stage.crowd().tracks()) {
    return track_cameras(tracks->people(), static_cast<float>(stage.crowd().laid_out_for().height), aspect, part);
  }
  return scene_cameras(stage.tuning().scene, static_cast<std::size_t>(stage.tuning().agents),
                       common_roles(roles_of(stage.characters())), stage.tuning().clothes);
}

render::Camera CameraGuide::begin_scene(const Stage& stage, float aspect, const PicturePart& part) {
  start_ = camera_at(cameras_of(stage, aspect, part).front().place);
  return start_;
}

render::Camera CameraGuide::home(const Stage& stage, float aspect, const PicturePart& part) const {
  return has_path() ? start_ : camera_at(cameras_of(stage, aspect, part).front().place);
}

bool CameraGuide::can_film(const Stage& stage) const {
  return has_path() || stage.animated().cut_scene() != nullptr || is_live(stage);
}

std::string CameraGuide::path_text() const {
  if (!keys_.empty()) return file_;
  return path_ == CameraPath::none ? "" : camera_path_words.at(static_cast<std::size_t>(path_));
}

std::string CameraGuide::camera_text(const Stage& stage, bool films) const {
  if (films) return is_live(stage) ? live_name_ : "";
  if (!behind_ || !behind_->agent()) return {};
  return std::string("follow:").append(follow_name(stage, *behind_->agent()));
}

render::Camera CameraGuide::moved(const Stage& stage, const render::Camera& camera, bool films, float aspect,
                                  const PicturePart& part) {
  if (films && !keys_.empty()) return along(keys_, to_seconds(stage.system().clock()));
  if (films && path_ != CameraPath::none) return along(path_, start_, to_seconds(stage.system().clock()));
  if (films && stage.animated().cut_scene() != nullptr) return stage.animated().cut_scene()->film();
  look_for_another(stage);
  const render::Camera next = films && is_live(stage) ? held_live(stage, camera, aspect, part) : camera;
  return behind_ ? behind_->moved(stage, next) : carried(stage, next);
}

// It goes back smoothly, since it may come from an agent far away.
render::Camera CameraGuide::held_live(const Stage& stage, const render::Camera& camera, float aspect,
                                      const PicturePart& part) {
  constexpr double seconds_to_go = 1.2;
  const GroundBounds& bounds = stage.crowd().tracks()->people().bounds();
  if (bounds != live_bounds_) {
    const auto cameras = cameras_of(stage, aspect, part);
    const NamedCamera* const named = find_camera(cameras, live_name_);
    live_place_ = camera_at(named != nullptr ? named->place : cameras.front().place);
    live_bounds_ = bounds;
  }
  const Ticks now = stage.system().clock(), before = std::exchange(clock_, now);
  const auto share = static_cast<float>(1.0 - std::exp(-to_seconds(now - before) / seconds_to_go));
  render::Camera next = live_place_;
  next.position = glm::mix(camera.position, live_place_.position, share);
  return next;
}

void CameraGuide::look_for_another(const Stage& stage) {
  if (!behind_ || !while_selected_ || stage.selected() == behind_->agent()) return;
  behind_ = stage.selected() ? std::optional(FollowCamera(*stage.selected())) : std::nullopt;
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
