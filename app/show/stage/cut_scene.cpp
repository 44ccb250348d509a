#include "app/show/stage/cut_scene.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include "app/character/cut_scene_models.h"
#include "app/people/crowd/cut_scene_layout.h"
#include "app/show/camera/scenes.h"

namespace throng::app {
namespace {

constexpr std::uint32_t actor = 0, balloon_agent = 1;
constexpr Ticks soon = ticks_per_second / 3;
constexpr anim::AbsoluteRoot origin;

}  // namespace

CutScene::CutScene(anim::AnimationSystem& system, Crowd& crowd, std::span<const CharacterSource> characters,
                   std::uint32_t camera_character)
    : system_(&system),
      crowd_(&crowd),
      actor_(&characters[crowd.characters()[actor]].roles),
      camera_(system.add_agent(camera_character)),
      camera_palette_(anim::allocate_aligned(4 * sizeof(anim::PaletteMatrix))),
      begun_(system.clock()) {
  advance();
}

void CutScene::play(std::uint32_t agent, int clip, Ticks fade, bool loop, const anim::AbsoluteRoot& root) {
  system_->agent(agent).play({.clip = clip, .fade = fade, .loop = loop, .absolute_root = root});
}

void CutScene::play_role(Role role, Ticks fade) {
  const auto playable = actor_->playable(role);
  if (playable) play(actor, actor_->clip(*playable), fade, true, root_of(actor));
}

anim::AbsoluteRoot CutScene::root_of(std::uint32_t agent) const {
  return system_->agent(agent).motion().absolute_root(system_->clock()).value_or(origin);
}

void CutScene::begin(Act act) {
  act_ = act;
  switch (act) {
    case Act::before:
      break;
    case Act::walk_on: {
      play(camera_.number, 0, {}, false, origin);
      if (has_balloon()) play(balloon_agent, carried, {}, true, origin);
      const anim::AbsoluteRoot start{.position = {0.0, 0.0, -walk_on_seconds * actor_->walk_speed}};
      const int walk = actor_->clip(Role::walk);
      if (actor_->can_walk()) play(actor, walk, {}, true, start);
      break;
    }
    case Act::let_go:
      play_role(Role::stand, soon);
      break;
    case Act::wave:
      if (has_balloon()) play(balloon_agent, rise, {}, false, root_of(actor));
      play_role(Role::wave, soon);
      break;
  }
}

void CutScene::advance() {
  const Ticks length = to_ticks(cut_scene_seconds);
  if (system_->clock() - begun_ >= length) {
    begun_ += (system_->clock() - begun_) / length * length;
    act_ = Act::before;
  }
  const Ticks now = system_->clock() - begun_;
  if (act_ == Act::before) begin(Act::walk_on);
  if (act_ == Act::walk_on && now >= to_ticks(walk_on_seconds)) begin(Act::let_go);
  if (act_ == Act::let_go && now >= to_ticks(release_seconds)) begin(Act::wave);
  put(actor, root_of(actor));
  if (has_balloon()) put(balloon_agent, root_of(act_ == Act::wave ? balloon_agent : actor));
  const PoseRequest camera{.agent = camera_, .palette = camera_palette_.get()};
  system_->update({&camera, 1});
}

void CutScene::put(std::uint32_t agent, const anim::AbsoluteRoot& root) {
  const glm::quat& turn = root.rotation;  // about +Y
  crowd_->put(agent, glm::vec3(root.position), {turn.w * turn.w - turn.y * turn.y, 2.0F * turn.w * turn.y});
}

render::Camera CutScene::film() const {
  const auto& lens = *reinterpret_cast<const anim::PaletteMatrix*>(camera_palette_.get());
  const glm::vec3 forward(-lens.rows[0][2], -lens.rows[1][2], -lens.rows[2][2]);
  return {.position = {lens.rows[0][3], lens.rows[1][3], lens.rows[2][3]},
          .yaw = std::atan2(-forward.x, -forward.z),
          .pitch = std::asin(std::clamp(forward.y, -1.0F, 1.0F)),
          .vertical_view = glm::radians(film_field_of_view)};
}

}  // namespace throng::app
