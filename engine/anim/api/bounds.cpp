#include <algorithm>
#include <cstdint>

#include "throng/crowd.h"

#include "engine/anim/api/crowd_parts.h"
#include "engine/anim/survey/entry_boxes.h"
#include "engine/base/glm_numbers.h"

namespace throng {
namespace {

constexpr std::int64_t poses_a_second = 60, fewest_poses = 12, most_poses = 10'000;

BoundingBox box_around(const BoundingSphere& sphere) {
  const glm::vec3 centre = to_glm(sphere.centre);
  return {.low = from_glm(centre - sphere.radius), .high = from_glm(centre + sphere.radius)};
}

/// Returns a box as floats that hold it, wider by what morphs can add.
BoundingBox widened(const anim::Box& box, double morph_reach) {
  constexpr double rounding = 1e-5;  // metres, of floats within a hundred metres
  return {.low = from_glm(glm::vec3(box.low - (morph_reach + rounding))),
          .high = from_glm(glm::vec3(box.high + (morph_reach + rounding)))};
}

void widen(BoundingBox& box, const BoundingBox& other) {
  box.low = from_glm(glm::min(to_glm(box.low), to_glm(other.low)));
  box.high = from_glm(glm::max(to_glm(box.high), to_glm(other.high)));
}

}  // namespace

BoundingSphere Character::bounds() const {
  if (data() == nullptr) return {};
  const anim::CharacterBounds& own = data()->baked->bounds;
  return {.centre = {0.0F, static_cast<float>(own.height / 2.0), 0.0F}, .radius = static_cast<float>(own.reach)};
}

BoundingBox Character::bounds(ClipId clip) const {
  if (!has(clip)) return {};
  Result<Crowd> crowd = Crowd::create(*this);
  if (!crowd) return box_around(bounds());
  const AgentId agent = crowd->add_agent();
  const Ticks duration = this->clip(clip).duration;
  const std::int64_t steps = std::clamp(duration * poses_a_second / ticks_per_second, fewest_poses, most_poses);
  BoundingBox box;
  for (std::int64_t step = 0; step <= steps; ++step) {
    const Ticks start = step == steps ? duration : duration / steps * step;
    crowd->agent(agent).play({.clip = clip, .start = start, .loop = false});
    if (step == 0) box = crowd->bounds(agent);
    widen(box, crowd->bounds(agent));
  }
  return box;
}

BoundingBox Crowd::bounds(AgentId agent) {
  constexpr const char* call = "Crowd::bounds";
  if (is_gone(call)) return {};
  const detail::CrowdCharacter* const played = parts_->character_of(agent, call);
  if (played == nullptr) return {};
  const anim::AgentView own = std::as_const(*parts_->system).agent(agent);
  if (own.graph().empty() || !own.can_pose_exactly()) return box_around(played->character.bounds());
  const detail::CharacterData& data = *played->character.data();
  const std::size_t entries = data.baked->entry_boxes.size();
  parts_->rows.resize(std::max(parts_->rows.size(), 3 * entries));
  auto* const palette = reinterpret_cast<anim::PaletteMatrix*>(parts_->rows.data());
  const anim::ExactPose pose{.agent = agent, .palette = palette};
  parts_->system->pose_exactly({&pose, 1});
  return widened(anim::posed_box(data.baked->entry_boxes, {palette, entries}), data.baked->morph_reach);
}

}  // namespace throng
