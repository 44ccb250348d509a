#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "app/character/source.h"
#include "app/people/crowd/crowd.h"
#include "app/show/stage/held_arms.h"
#include "app/show/stage/lent_processes.h"
#include "engine/anim/agent/character_rigs.h"
#include "engine/anim/agent/targeted_processes.h"

namespace throng::app {

/// Hands of a grown-up and a child who go hand in hand. The clips of their arms bring the hands near each other; from
/// there both reach for one place between them, which follows from where the two stand. Where they cannot meet, or have
/// no hands at their bone levels, neither holds one out.
class JoinedHands : public LentProcesses<anim::ReachProcess> {
 public:
  /// People join hands from so many pixels on, and go on down to the second number.
  static constexpr float pixels_to_begin = 44.0F, pixels_to_go_on = 38.0F;

  /// Takes RigKinds::limbs of each character. `characters`, `rigs` and `system` outlive this.
  JoinedHands(std::span<const CharacterSource> characters, std::span<const std::unique_ptr<anim::CharacterRigs>> rigs,
              std::vector<std::optional<anim::EntityPools::Kind>> kinds, anim::AnimationSystem& system);

  /// Finds the pairs that go hand in hand: a child comes right after its grown-up. Call it when agents were made anew,
  /// or when things went into other hands.
  void reset(const Crowd& crowd);

  /// Finds the pairs whose hands can meet now. Call it before an update. `near` are the agents in view that are
  /// pixels_to_go_on tall or taller, and may have others among them; it ascends by agent.
  void find(const Crowd& crowd, std::span<const anim::VisibleAgent> near);
  /// Returns [agent] 1 for each agent whose partner's hand is away, as HeldArms::show takes it.
  std::span<const std::uint8_t> away() const { return away_; }
  /// Joins the hands that can meet and are held out. Call it after HeldArms::show.
  void join(const HeldArms& arms);
  void go_back_to(const Moment& moment);

 private:
  /// An arm that is held out to a partner, as its clip has it in the middle; in model space.
  struct Arm {
    std::uint32_t limb = 0;
    float length = 0.0F;  ///< of the straight arm, from shoulder to wrist; 0: there is no such arm
    glm::vec3 shoulder{0.0F}, elbow{0.0F}, wrist{0.0F}, palm{0.0F};
  };
  struct Pair {
    std::uint32_t grown_up = 0, child = 0;
    std::uint8_t characters[2] = {};
    bool meets = false;                       ///< the hands can meet now
    glm::vec3 grown_ups{0.0F}, childs{0.0F};  ///< places for the wrists to meet, each in its own model space
  };

  Arm arm_of(std::size_t character, Role role) const;
  bool is_near(const Pair& pair, std::span<const anim::VisibleAgent> near) const;
  bool can_meet(const Crowd& crowd, Pair& pair) const;
  static glm::vec3 wrist_for(const Arm& arm, const glm::vec3& palm);
  bool reach(std::uint32_t agent, const Arm& arm, const glm::vec3& target);

  std::span<const CharacterSource> characters_;
  std::span<const std::unique_ptr<anim::CharacterRigs>> rigs_;
  std::vector<std::array<Arm, 2>> arms_;        // [character], of the grown-up and of the child
  std::vector<std::size_t> levels_with_hands_;  // [character] bone levels that have both wrists
  std::vector<Pair> pairs_;
  std::vector<std::uint8_t> away_;  // [agent]
  bool is_new_ = true;              // no agent has been seen with free hands
};

}  // namespace throng::app
