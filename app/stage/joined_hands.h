#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "app/character/source.h"
#include "app/crowd/crowd.h"
#include "app/stage/held_arms.h"
#include "app/stage/lent_processes.h"
#include "engine/anim/agent/character_rigs.h"
#include "engine/anim/agent/reach_process.h"

namespace throng::app {

/// Hands of a grown-up and a child who go hand in hand. The clips of their arms bring the hands near each other; from
/// there both reach for one place between them. A pair that is too far apart for its arms lets go.
class JoinedHands {
 public:
  using Moment = LentProcesses<anim::ReachProcess>::Moment;

  /// People join hands from so many pixels on, and go on down to the second number.
  static constexpr float pixels_to_begin = 44.0F, pixels_to_go_on = 38.0F;

  /// Takes RigKinds::limbs of each character. `characters`, `rigs` and `system` outlive this.
  JoinedHands(std::span<const CharacterSource> characters, std::span<const std::unique_ptr<anim::CharacterRigs>> rigs,
              std::vector<std::optional<anim::EntityPools::Kind>> kinds, anim::AnimationSystem& system);

  /// Finds who goes hand in hand: a child comes right after its grown-up. Call it when agents were made anew, or when
  /// things went into other hands.
  void reset(const Crowd& crowd);

  /// Joins the hands of those who are seen near by and whose arms are held out. Call it before an update.
  void join(const Crowd& crowd, const HeldArms& arms, std::span<const anim::VisibleAgent> visible);
  /// Takes the post process from agents that no longer need it, or that are not in `visible`, which ascends by agent.
  void take_back(std::span<const anim::VisibleAgent> visible) { lent_.take_back(visible); }

  const Moment& moment() const { return lent_.moment(); }
  void go_back_to(const Moment& moment);

 private:
  /// An arm that is held out to somebody, as its clip has it in the middle; in model space.
  struct Arm {
    std::uint32_t limb = 0;
    float length = 0.0F;  ///< of the straight arm, from shoulder to wrist; 0: there is no such arm
    glm::vec3 shoulder{0.0F}, elbow{0.0F}, wrist{0.0F}, palm{0.0F};
  };
  struct Pair {
    std::uint32_t grown_up = 0, child = 0;
    bool joined = false;
  };
  static constexpr std::array<Role, 2> roles{Role::lead, Role::led};

  Arm arm_of(std::size_t character, Role role) const;
  const Arm& arm(const Crowd& crowd, std::uint32_t agent, std::size_t side) const {
    return arms_[crowd.characters()[agent]].at(side);
  }
  bool is_near(const Pair& pair, const HeldArms& arms, std::span<const anim::VisibleAgent> visible) const;
  void join(const Crowd& crowd, Pair& pair);
  static glm::vec3 wrist_for(const Arm& arm, const glm::vec3& palm);
  bool reach(std::uint32_t agent, const Arm& arm, const glm::vec3& target);

  std::span<const CharacterSource> characters_;
  std::span<const std::unique_ptr<anim::CharacterRigs>> rigs_;
  std::vector<std::array<Arm, 2>> arms_;  // [character], of the grown-up and of the child
  std::vector<Pair> pairs_;
  bool is_new_ = true;  // nobody has been seen with free hands
  LentProcesses<anim::ReachProcess> lent_;
};

}  // namespace throng::app
