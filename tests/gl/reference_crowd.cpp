#include "tests/gl/reference_crowd.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

namespace throng::app::test {
namespace {

// A player counts its speed in 65536ths; any other speed would be another pose seconds later.
double counted_speed(float speed) { return std::round(static_cast<double>(speed) * 65536.0) / 65536.0; }

double eased(double x) { return x * x * (3.0 - 2.0 * x); }

// Does what EaseBlender is specified to do: normalised linear interpolation over the shorter arc.
anim::StateTransform blended(const anim::StateTransform& from, const anim::StateTransform& to, double weight) {
  const double side = glm::dot(from.rotation, to.rotation) < 0.0 ? -1.0 : 1.0;
  return {.rotation = glm::normalize(from.rotation * (1.0 - weight) + to.rotation * (side * weight)),
          .position = glm::mix(from.position, to.position, weight),
          .scale = glm::mix(from.scale, to.scale, weight)};
}

}  // namespace

ReferenceCrowd::ReferenceCrowd(const CharacterSource& character, std::vector<anim::Clip> clips, const Tuning& tuning)
    : character_(character),
      clips_(std::move(clips)),
      crowd_(tuning.scene, static_cast<std::size_t>(tuning.agents), tuning.seed, character.roles),
      plays_(crowd_.size()) {
  for (std::size_t agent = 0; agent < crowd_.size(); ++agent) {
    const auto clip = static_cast<std::size_t>(crowd_.minds().clips()[agent]);
    const double seconds = to_seconds(character.character->clips[clip].duration);
    const double start = static_cast<double>(crowd_.looks().start_phases[agent]) * seconds;
    plays_[agent].push_back(
        {.clip = clip, .stretches = {{.position = start, .speed = speed_of(static_cast<std::uint32_t>(agent))}}});
  }
}

double ReferenceCrowd::speed_of(std::uint32_t agent) const { return counted_speed(crowd_.playback_speeds()[agent]); }

void ReferenceCrowd::advance(Ticks delta) {
  clock_ += delta;
  for (const ClipRequest& request : crowd_.advance(delta)) {
    plays_[request.agent].push_back({.asked = clock_,
                                     .clip = static_cast<std::size_t>(request.clip),
                                     .fade = to_ticks(static_cast<double>(request.fade_seconds)),
                                     .stretches = {{.since = clock_, .speed = speed_of(request.agent)}}});
  }
  for (std::uint32_t mover = 0; mover < crowd_.walkers().count() + crowd_.marchers().count(); ++mover) keep_pace(mover);
}

// The newest clip of an agent plays at the speed that its feet have now; clips that fade out keep their speed.
void ReferenceCrowd::keep_pace(std::uint32_t agent) {
  std::vector<Stretch>& stretches = plays_[agent].back().stretches;
  const Stretch& last = stretches.back();
  if (last.speed == speed_of(agent)) return;
  stretches.push_back({.since = clock_,
                       .position = last.position + to_seconds(clock_ - last.since) * last.speed,
                       .speed = speed_of(agent)});
}

bool ReferenceCrowd::fades(std::uint32_t agent) const {
  const Play& last = plays_[agent].back();
  return clock_ > last.asked && clock_ < last.asked + last.fade;
}

std::vector<anim::StateTransform> ReferenceCrowd::locals_of(const Play& play, const PoseMoment& moment) const {
  const anim::BakedClip& clip = character_.character->clips[play.clip];
  const anim::Skeleton& skeleton = character_.model.skeleton;
  const double duration = to_seconds(clip.duration);
  // A pose of a later moment was made with the speed of the moment at which it was made.
  const auto known = std::find_if(play.stretches.rbegin(), play.stretches.rend(),
                                  [&](const Stretch& stretch) { return stretch.since <= moment.evaluated; });
  const double played = known->position + to_seconds(moment.time - known->since) * known->speed;
  const double seconds = std::fmod(played, duration);
  auto locals = anim::reference_pose(skeleton, &clips_[play.clip], seconds).locals;
  // The crowd moves its agents itself, so the root motion of a clip is no part of the pose.
  const anim::FineTicks position = to_ticks(seconds) * anim::fine_ticks_per_tick;
  const anim::RootMotion back = inverse(displacement(clip.root_motion, 0, position, false));
  const glm::dquat turn = glm::angleAxis(back.yaw, glm::dvec3(0.0, 1.0, 0.0));
  for (std::size_t bone = 0; bone < locals.size(); ++bone) {
    const anim::Bone& root = skeleton.bones[bone];
    if (root.parent >= 0) continue;
    const glm::dvec3 place = root.prefix * glm::dvec4(locals[bone].position, 1.0);
    locals[bone].position = glm::inverse(root.prefix) * glm::dvec4(turn * place + back.translation, 1.0);
    const glm::dquat above =
        glm::quat_cast(glm::dmat3(root.prefix) / std::cbrt(glm::determinant(glm::dmat3(root.prefix))));
    locals[bone].rotation = glm::conjugate(above) * turn * above * locals[bone].rotation;
  }
  return locals;
}

std::vector<glm::dmat4> ReferenceCrowd::palette(std::uint32_t agent, const PoseMoment& moment) const {
  std::vector<anim::StateTransform> locals;
  for (const Play& play : plays_[agent]) {
    if (play.asked > moment.evaluated) break;
    std::vector<anim::StateTransform> next = locals_of(play, moment);
    const double faded = play.fade == Ticks{} ? 1.0 : to_seconds(moment.time - play.asked) / to_seconds(play.fade);
    if (faded < 1.0) {
      for (std::size_t bone = 0; bone < next.size(); ++bone) {
        next[bone] = blended(locals[bone], next[bone], eased(faded));
      }
    }
    locals = std::move(next);
  }
  const anim::Skeleton& skeleton = character_.model.skeleton;
  const auto kept = static_cast<std::size_t>(skeleton.level_bone_counts[moment.fade_level]);
  for (std::size_t bone = kept; moment.faded > 0.0 && bone < locals.size(); ++bone) {
    const anim::StateTransform stands_still = anim::to_local(skeleton, static_cast<int>(bone), {});
    locals[bone] = blended(locals[bone], stands_still, moment.faded);
  }
  return anim::pose_from_locals(skeleton, std::move(locals)).palette;
}

std::vector<glm::dvec3> ReferenceCrowd::surface(std::uint32_t agent, const PoseMoment& moment,
                                                std::size_t level) const {
  return surface_of(palette(agent, moment), level);
}

std::vector<glm::dvec3> ReferenceCrowd::surface_of(const std::vector<glm::dmat4>& palette, std::size_t level) const {
  const anim::Skeleton& skeleton = character_.model.skeleton;
  std::vector<glm::dvec3> positions;
  for (const anim::SkinnedMesh& mesh : character_.model.meshes) {
    for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
      glm::dvec4 sum(0.0);
      for (int influence = 0; influence < 4; ++influence) {
        // The skeleton is rigid: its palette has one entry a bone.
        const int bone = anim::nearest_kept_bone(skeleton, mesh.palette_entries[vertex][influence],
                                                 skeleton.level_bone_counts[level]);
        sum += static_cast<double>(mesh.weights[vertex][influence]) *
               (palette[static_cast<std::size_t>(bone)] * glm::dvec4(mesh.positions[vertex], 1.0));
      }
      positions.emplace_back(sum);
    }
  }
  return positions;
}

glm::dvec3 ReferenceCrowd::to_world(std::uint32_t agent, const glm::dvec3& position) const {
  const auto cosine = static_cast<double>(crowd_.headings()[agent].cosine);
  const auto sine = static_cast<double>(crowd_.headings()[agent].sine);
  const glm::dvec3 turned(cosine * position.x + sine * position.z, position.y, cosine * position.z - sine * position.x);
  return glm::dvec3(crowd_.positions()[agent]) + scale(agent) * turned;
}

}  // namespace throng::app::test
