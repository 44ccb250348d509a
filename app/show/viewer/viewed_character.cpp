#include "app/show/viewer/viewed_character.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/base/pose.h"

namespace throng::app {
namespace {

constexpr int times_of_a_clip = 8;
constexpr float room_around = 1.06F;   // the points are not the whole surface
constexpr float least_radius = 1e-6F;  // metres

// Reads a state that anim::store_state() wrote.
anim::StateTransform load_state(const float* pose, int bone, int components) {
  pose += bone / anim::packet_bones * components * anim::packet_bones + bone % anim::packet_bones;
  const auto at = [&](int component) { return static_cast<double>(pose[component * anim::packet_bones]); };
  anim::StateTransform state{.rotation = {at(3), at(0), at(1), at(2)}, .position = {at(4), at(5), at(6)}};
  if (components > 7) state.scale = {at(7), at(8), at(9)};
  return state;
}

anim::PaletteMatrix rows_of(const glm::dmat4& matrix) {
  anim::PaletteMatrix rows{};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) rows.rows[row][column] = static_cast<float>(matrix[column][row]);
  }
  return rows;
}

std::vector<anim::PaletteMatrix> bind_palette(const anim::Skeleton& skeleton) {
  const std::vector<float> still = anim::still_pose(skeleton);
  std::vector<anim::StateTransform> locals;
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    locals.push_back(anim::to_local(skeleton, bone, load_state(still.data(), bone, skeleton.components())));
  }
  std::vector<anim::PaletteMatrix> palette;
  for (const glm::dmat4& entry : anim::pose_from_locals(skeleton, std::move(locals)).palette) {
    palette.push_back(rows_of(entry));
  }
  return palette;
}

anim::PlayRequest held(const anim::Character& character, int clip, double seconds) {
  const Ticks duration = character.clips[static_cast<std::size_t>(clip)].duration;
  return {.clip = clip, .fade = {}, .speed = 0.0, .start = std::min(to_ticks(seconds), duration)};
}

glm::vec3 times(const anim::PaletteMatrix& matrix, const glm::vec4& point) {
  const auto row = [&](int i) {
    const float* const of = matrix.rows[i];
    return of[0] * point.x + of[1] * point.y + of[2] * point.z + of[3] * point.w;
  };
  return {row(0), row(1), row(2)};
}

}  // namespace

ViewedCharacter::ViewedCharacter(const CharacterSource& source)
    : source_(&source),
      palette_(anim::allocate_aligned(palette_bytes())),
      bind_(bind_palette(source.character->skeleton)) {
  for (int bone = 0; bone < source.character->skeleton.bone_count(); ++bone) {
    joints_.push_back(anim::joint_place(source.character->skeleton, bone));
  }
}

Result<std::unique_ptr<ViewedCharacter>> ViewedCharacter::create(const CharacterSource& source,
                                                                 anim::StreamKind stream) {
  std::unique_ptr<ViewedCharacter> viewed(new ViewedCharacter(source));
  auto system =
      anim::AnimationSystem::create(source.character, {.stream = stream, .hash = false, .trace = anim::Tracing::off});
  if (!system) return system.error();
  viewed->system_ = std::move(*system);
  viewed->agent_ = viewed->system_->add_agent();
  return viewed;
}

void ViewedCharacter::pose(const ViewedPose& wanted) {
  shows_bind_ = wanted.bind_pose;
  entries_ = source_->character->level_entries[wanted.bone_level];
  anim::Agent agent = system_->agent(agent_);
  agent.play(held(character(), wanted.clip, wanted.seconds));
  if (wanted.blended != no_clip) {
    anim::PlayRequest second = held(character(), wanted.blended, wanted.blended_seconds);
    second.held_fraction = wanted.weight;
    agent.play(second);
  }
  const PoseRequest update{.agent = agent_, .level = wanted.bone_level, .palette = palette_.get()};
  system_->update({&update, 1});
}

void ViewedCharacter::add_surface(std::vector<glm::vec3>& points) const {
  const anim::SurfacePoints& surface = character().surface_points;
  for (std::size_t point = 0; point < surface.count(); ++point) {
    glm::vec3 place(0.0F);
    for (const anim::PointInfluence& influence : surface.of(point)) {
      place += times(palette()[influence.entry], influence.weighted);
    }
    points.push_back(place);
  }
}

std::vector<glm::vec3> ViewedCharacter::surface_at_many_times() {
  std::vector<glm::vec3> points;
  for (std::size_t clip = 0; clip < character().clips.size(); ++clip) {
    if (character().clips[clip].is_empty()) continue;
    const double duration = to_seconds(character().clips[clip].duration);
    for (int time = 0; time < times_of_a_clip; ++time) {
      pose({.clip = static_cast<int>(clip), .seconds = duration * time / times_of_a_clip});
      add_surface(points);
    }
  }
  return points;
}

ViewedRoom ViewedCharacter::surroundings() {
  const std::vector<glm::vec3> points = surface_at_many_times();
  if (points.empty()) return {};
  glm::vec3 lowest = points.front(), highest = points.front();
  for (const glm::vec3& point : points) {
    lowest = glm::min(lowest, point);
    highest = glm::max(highest, point);
  }
  ViewedRoom room{.centre = (lowest + highest) / 2.0F, .radius = 0.0F, .across = 0.0F};
  for (const glm::vec3& point : points) {
    const glm::vec3 away = point - room.centre;
    room.radius = std::max(room.radius, glm::length(away));
    room.across = std::max(room.across, std::hypot(away.x, away.z));
  }
  room.radius = std::max(room.radius * room_around, least_radius);
  room.across = std::max(room.across * room_around, least_radius);
  room.half_height = std::max((highest.y - lowest.y) / 2.0F * room_around, least_radius);
  return room;
}

std::span<const anim::PaletteMatrix> ViewedCharacter::palette() const {
  if (shows_bind_) return std::span(bind_).first(entries_);
  return {reinterpret_cast<const anim::PaletteMatrix*>(palette_.get()), entries_};
}

std::optional<glm::vec3> ViewedCharacter::joint(int bone) const {
  const anim::JointPlace& place = joints_[static_cast<std::size_t>(bone)];
  if (place.entry < 0 || static_cast<std::size_t>(place.entry) >= entries_) return std::nullopt;
  return times(palette()[static_cast<std::size_t>(place.entry)], glm::vec4(glm::vec3(place.position), 1.0F));
}

bool ViewedCharacter::add_morph_weights(std::span<float> weights) const {
  if (shows_bind_) return false;
  const anim::AnimationSystem& system = *system_;
  return system.agent(agent_).motion().add_morph_weights(system.clock(), weights);
}

}  // namespace throng::app
