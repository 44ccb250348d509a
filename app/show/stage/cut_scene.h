#pragma once

#include <cstdint>
#include <span>

#include "throng/render/camera.h"

#include "app/character/source.h"
#include "app/people/crowd/crowd.h"
#include "engine/anim/agent/animation_system.h"
#include "engine/anim/base/aligned_bytes.h"

namespace throng::app {

/// A short cut scene: a person comes with a balloon, lets it go and waves after it; a camera films it, and it begins
/// anew. Person, balloon and camera are agents of one system, each a character of its own, placed in the world by the
/// absolute roots of their clips (paper 2.2.1: "useful for cut scenes and pre-canned sequences").
class CutScene {
 public:
  /// Begins the scene. The crowd's first two agents are the actor and, where there is a second, the balloon
  /// (cut_scene_layout). The camera, of the character `camera_character`, is one more agent of the system. System,
  /// crowd and characters outlive the scene.
  CutScene(anim::AnimationSystem& system, Crowd& crowd, std::span<const CharacterSource> characters,
           std::uint32_t camera_character);

  /// Plays the next step of the script, puts actor and balloon where their roots are, and poses the camera. Call it
  /// when the clocks of system and crowd have advanced.
  void advance();

  /// A place in the script.
  struct Moment {
    Ticks begun{};
    std::uint8_t act = 0;
  };
  Moment moment() const { return {begun_, static_cast<std::uint8_t>(act_)}; }
  void go_back_to(const Moment& moment) { begun_ = moment.begun, act_ = static_cast<Act>(moment.act); }

  /// Returns the scene's camera as it stands.
  render::Camera film() const;

 private:
  enum class Act : std::uint8_t { before, walk_on, let_go, wave };

  bool has_balloon() const { return crowd_->size() > 1; }
  void begin(Act act);
  void play(std::uint32_t agent, int clip, Ticks fade, bool loop, const anim::AbsoluteRoot& root);
  void play_role(Role role, Ticks fade);
  anim::AbsoluteRoot root_of(std::uint32_t agent) const;
  void put(std::uint32_t agent, const anim::AbsoluteRoot& root);

  anim::AnimationSystem* system_;
  Crowd* crowd_;
  const CharacterRoles* actor_;
  AgentId camera_;
  anim::AlignedBytes camera_palette_;
  Ticks begun_;
  Act act_ = Act::before;
};

}  // namespace throng::app
