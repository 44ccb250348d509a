#include "app/show/follow_camera.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "app/files/nearest_names.h"
#include "app/show/stage/stage.h"
#include "engine/tracks/smooth_track.h"

namespace throng::app {
namespace {

constexpr float behind_by = 2.6F, above_by = 1.45F, looked_at = 0.6F;  // of the person's height
constexpr double place_seconds = 0.12, turn_seconds = 1.2;             // in which most of the way is made good
constexpr double least_step = 1.0 / 60.0;                              // seconds, also while the crowd pauses
constexpr float jump = 4.0F;                                           // metres in a frame: the clock was moved

float share_of(double seconds, double time) { return 1.0F - static_cast<float>(std::exp(-seconds / time)); }

std::optional<std::uint32_t> number_of(const std::string& name, std::size_t agents) {
  std::uint32_t number = 0;
  if (!name.starts_with('#')) return {};
  const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), number);
  const bool is_one = error == std::errc() && end == name.data() + name.size() && number < agents;
  return is_one ? std::optional(number) : std::nullopt;
}

std::optional<std::uint32_t> person_of(const Trajectories& all, const std::string& id) {
  const auto found = std::ranges::find(all.persons, id, &PersonTrack::id);
  if (found == all.persons.end()) return {};
  return static_cast<std::uint32_t>(found - all.persons.begin());
}

}  // namespace

// A file says where a person begins and ends.
std::optional<FollowCamera::Pose> FollowCamera::pose_of(const Stage& stage, std::uint32_t agent) {
  const Crowd& crowd = stage.crowd();
  const FollowedTracks* const tracks = crowd.tracks();
  if (tracks == nullptr) {
    const Heading heading = crowd.headings()[agent];
    return Pose{crowd.positions()[agent], std::atan2(heading.sine, heading.cosine)};
  }
  const Trajectories& all = tracks->people().trajectories();
  const double seconds = tracks->clock().seconds;
  if (all.persons[agent].rows.empty() || (all.is_live && !tracks->people().is_there(agent, seconds))) return {};
  return Pose{tracks->people().position(agent, seconds), tracks->people().step(agent, seconds).heading};
}

render::Camera FollowCamera::behind(const Stage& stage, const Pose& pose) const {
  const float tall = body_of(stage, *agent_).height;
  const glm::vec3 ahead(std::sin(pose.heading), 0.0F, std::cos(pose.heading));
  render::Camera camera;
  camera.position = pose.place - behind_by * tall * ahead + glm::vec3(0.0F, above_by * tall, 0.0F);
  camera.yaw = pose.heading + std::numbers::pi_v<float>;
  camera.pitch = -std::atan2(above_by - looked_at, behind_by);
  return camera;
}

void FollowCamera::find_by_id(const Stage& stage) {
  const FollowedTracks* const tracks = stage.crowd().tracks();
  if (id_.empty() || tracks == nullptr) return;
  const Trajectories& all = tracks->people().trajectories();
  if (!agent_ || all.persons[*agent_].id != id_) agent_ = person_of(all, id_);
}

render::Camera FollowCamera::moved(const Stage& stage, const render::Camera& camera) {
  find_by_id(stage);
  const auto wanted = agent_ ? pose_of(stage, *agent_) : std::nullopt;
  const Ticks now = stage.system().clock(), before = std::exchange(clock_, now);
  if (!wanted) return camera;
  if (!pose_) {
    pose_ = wanted;
    return behind(stage, *pose_);
  }
  const Pose from = *pose_;
  const double seconds = std::max(to_seconds(now - before), least_step);
  const bool jumps = glm::distance(from.place, wanted->place) > jump;
  const float turn = wrapped_angle(wanted->heading - from.heading) * (jumps ? 1.0F : share_of(seconds, turn_seconds));
  pose_->place += (wanted->place - from.place) * (jumps ? 1.0F : share_of(seconds, place_seconds));
  pose_->heading += turn;
  const glm::vec3 offset = camera.position - from.place;
  const float sine = std::sin(turn), cosine = std::cos(turn);
  render::Camera next = camera;
  next.position =
      pose_->place + glm::vec3(offset.x * cosine + offset.z * sine, offset.y, offset.z * cosine - offset.x * sine);
  next.yaw += turn;
  return next;
}

std::string follow_name(const Stage& stage, std::uint32_t agent) {
  const bool has_id = stage.tuning().scene == Scene::tracks && stage.trajectories() != nullptr;
  const std::string id = has_id ? stage.trajectories()->persons[agent].id : "";
  return id.empty() ? std::string("#").append(std::to_string(agent)) : id;
}

Result<FollowCamera> follow_camera(const Stage& stage, const std::string& name) {
  const Trajectories* const all = stage.tuning().scene == Scene::tracks ? stage.trajectories().get() : nullptr;
  if (const auto person = all != nullptr && !all->is_live ? person_of(*all, name) : std::nullopt) {
    return FollowCamera(*person);
  }
  if (const auto number = number_of(name, stage.crowd().size())) return FollowCamera(*number);
  if (all == nullptr) {
    return Error{"the crowd has agents #0 to #" + std::to_string(stage.crowd().size() - 1)};
  }
  if (all->is_live) return FollowCamera(name);
  std::vector<std::string> ids;
  for (const PersonTrack& person : all->persons) ids.push_back(person.id);
  return Error{all->file + " has no person of that id; nearest are " + nearest_names(name, ids)};
}

}  // namespace throng::app
