#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "app/character/source.h"
#include "app/people/crowd/crowd.h"
#include "app/show/stage/arm_channel.h"
#include "engine/anim/agent/animation_system.h"
#include "engine/anim/lod/lod.h"

namespace throng::app {

/// Arms that hold something: each plays its clip over the clips of the whole body, on the joints of that arm. Only
/// agents whose things can be seen have the layer, so the many far away are posed without it.
class HeldArms {
 public:
  /// An arm begins to hold when its agent is so many pixels tall, and goes on down to the second number. Smaller people
  /// are drawn as about one silhouette. Poses do not depend on meshes, which a run that draws nothing does not have.
  static constexpr float pixels_to_begin = 16.0F, pixels_to_go_on = 13.0F;

  /// `characters` and `system` outlive this.
  HeldArms(std::span<const CharacterSource> characters, anim::AnimationSystem& system);

  /// Gives the channel of an arm to each agent that holds something. Call it when agents were made anew and play
  /// something, or when things went into other hands.
  void reset(const Crowd& crowd);

  /// Returns whether no agent holds anything in an arm.
  bool empty() const { return arms_.empty(); }
  /// Lets arms hold their things where these are large enough to be seen. Call it before an update. `near` are the
  /// agents in view that are pixels_to_go_on tall or taller. `away` has [agent] 1 where the hand that it would hold is
  /// away; empty: no agent's is.
  void show(const Crowd& crowd, std::span<const anim::VisibleAgent> near, std::span<const std::uint8_t> away = {});

  /// Finds out which arms hold their things now; call it when the system has gone back to another moment.
  void find_shown();

  /// Returns whether the thing of an agent is to be drawn: its arm holds it now, or the whole body does in its role, or
  /// its character has no clip of an arm that could.
  bool shows_thing(const Crowd& crowd, std::uint32_t agent) const {
    if (agent >= arm_of_.size() || arm_of_[agent] == none) return true;
    return arms_[arm_of_[agent]].near_in == frame_ &&
           is_drawn_in_role(crowd.minds().things()[agent], crowd.minds().roles()[agent]);
  }
  /// Returns whether the arm of an agent holds something now, over the clips of the whole body.
  bool holds(std::uint32_t agent) const {
    return agent < arm_of_.size() && arm_of_[agent] != none && arms_[arm_of_[agent]].turn == Turn::on;
  }
  /// Returns how many arms hold something now.
  std::size_t shown() const { return shown_.size(); }

 private:
  enum class Turn : std::uint8_t { off, on, leaving };
  struct Arm {
    ChannelId channel;
    bool keeps_step = false;
    Turn turn = Turn::off;
    std::uint32_t near_in = 0;  ///< the frame in which it was drawn with its thing
    Ticks gone_at{};            ///< when it has left, while it leaves
  };
  static constexpr std::uint32_t none = ~0U;

  int mask_of(std::size_t character, Role arm);
  void give(const Crowd& crowd, std::uint32_t agent, HeldThing thing);
  void turn_on(std::uint32_t agent, Arm& arm, bool at_once);
  void turn_off(std::uint32_t agent, Arm& arm);
  bool goes_on(std::uint32_t agent);

  std::span<const CharacterSource> characters_;
  anim::AnimationSystem* system_;
  std::vector<std::array<int, role_count>> masks_;  // [character], by arm
  std::vector<std::uint32_t> arm_of_;               // [agent] index into arms_, or none
  std::vector<Arm> arms_;
  std::vector<std::uint32_t> shown_;  // agents whose arm holds its thing, or lets go of it
  std::uint32_t frame_ = 0;
};

}  // namespace throng::app
