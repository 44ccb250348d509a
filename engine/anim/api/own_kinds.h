#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "throng/processes.h"

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/agent/character_rigs.h"
#include "engine/anim/api/character_data.h"
#include "engine/anim/api/step_process.h"
#include "engine/anim/entity/socket.h"
#include "engine/anim/kernel/limb/chain_reach.h"
#include "engine/anim/rig/spring_rig.h"

namespace throng::detail {

/// The kinds of entities of one character in one crowd. Each is added to the system when the first process needs it,
/// because a character has room for few. The system keeps pointers into this object.
class OwnKinds {
 public:
  using Kind = anim::EntityPools::Kind;

  OwnKinds(anim::AnimationSystem& system, CharacterId character, std::shared_ptr<const CharacterBody> body)
      : system_(&system), character_(character), body_(std::move(body)) {}

  /// Returns the kind of a rig. Errors: the character has no such rig, or no more kinds can be added.
  Result<Kind> rig(anim::EntityType type);
  Result<std::uint32_t> limb(Limb limb) const;
  /// Returns the kind of a chain, one kind for the same bones.
  Result<Kind> chain(const ChainReach& settings);
  /// Returns the kind of springs, one kind for the same chains and colliders.
  Result<Kind> springs(const Springs& settings);

  /// A socket: its kind, and its place among the sockets of that kind.
  struct Place {
    Kind kind = 0;
    std::uint32_t number = 0;
  };
  Result<Place> socket(const Socket& settings);

  /// Adds a step, and returns its number.
  Result<std::uint32_t> add_step(const StepKind& step);
  /// Returns the kind of a step; nothing if there is none of this number.
  std::optional<Kind> step(std::uint32_t number) const;

 private:
  struct Rig {
    anim::EntityType type;
    Kind kind;
  };
  struct Chains {
    int first = 0;
    int last = 0;
    std::vector<anim::ReachChain> chains;
    anim::EntityKind own;
    Kind kind = 0;
  };
  struct SpringSet {
    std::string key;
    anim::SpringRig rig;
    anim::EntityKind own;
    Kind kind = 0;
  };
  struct Step {
    StepKind step;
    anim::EntityKind own;
    Kind kind = 0;
  };

  const anim::Skeleton& skeleton() const { return system_->characters()[character_].skeleton; }
  /// Returns the reason why a rig is missing, as the survey of the character's limbs says it.
  std::string why_missing() const;
  Result<int> bone(std::string_view name) const;
  /// Adds the kind of the last element, or takes that away again.
  template <typename Owned>
  Result<Kind> add_last(std::deque<Owned>& all, const char* call = "Agent::add");
  Result<Kind> add(const anim::EntityKind& kind, const char* call = "Agent::add") {
    return system_->characters().add_entity_kind(kind, character_, call);
  }

  anim::AnimationSystem* system_;
  CharacterId character_;
  std::shared_ptr<const CharacterBody> body_;
  std::vector<Rig> rigs_;
  std::deque<Chains> chains_;  // deques, because their elements stay where they are
  std::deque<SpringSet> springs_;
  std::deque<Step> steps_;
  anim::SocketPlaces sockets_;
  std::optional<anim::EntityKind> socket_kind_;
  Kind socket_number_ = 0;
};

}  // namespace throng::detail
