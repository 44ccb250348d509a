#include "engine/anim/api/own_kinds.h"

#include <algorithm>

#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/entity/chain_reach_entity.h"
#include "engine/anim/entity/spring_bones_entity.h"
#include "engine/anim/kernel/limb/joint_place.h"
#include "engine/base/glm_numbers.h"
#include "engine/base/text/plain_text.h"

namespace throng::detail {
namespace {

anim::SpringOptions options_of(const SpringChain& chain) {
  return {.stiffness = chain.stiffness,
          .damping = chain.damping,
          .drag = chain.drag,
          .gravity = to_glm(chain.gravity),
          .radius = chain.radius};
}

template <typename Number>
void append(std::string& key, const Number& number) {
  key.append(reinterpret_cast<const char*>(&number), sizeof(number));
}

/// Returns the settings as bytes that are the same for the same settings.
std::string key_of(const Springs& settings) {
  std::string key;
  for (const SpringChain& chain : settings.chains) {
    key.append(chain.first).push_back('\0');
    key.append(chain.last).push_back('\0');
    for (const float number : {chain.stiffness, chain.damping, chain.drag, chain.radius, chain.tip})
      append(key, number);
    append(key, chain.gravity);
  }
  key.push_back('\0');
  for (const SpringCollider& collider : settings.colliders) {
    key.append(collider.bone).push_back('\0');
    append(key, collider.from);
    append(key, collider.to);
    append(key, collider.radius);
  }
  return key;
}

}  // namespace

std::string OwnKinds::why_missing() const {
  std::string why = skeleton().name + ": the character has no such rig";
  for (const std::string& reason : body_->rigs.missing()) why += "; " + reason;
  return why;
}

template <typename Owned>
Result<OwnKinds::Kind> OwnKinds::add_last(std::deque<Owned>& all, const char* call) {
  const Result<Kind> kind = add(all.back().own, call);
  if (kind) {
    all.back().kind = *kind;
  } else {
    all.pop_back();
  }
  return kind;
}

Result<int> OwnKinds::bone(std::string_view name) const {
  const int found = anim::find_bone(skeleton(), name);
  if (found < 0) {
    return Error{skeleton().name + ": the character has no bone named \"" + plain_text(std::string(name)) + "\""};
  }
  return found;
}

Result<OwnKinds::Kind> OwnKinds::rig(anim::EntityType type) {
  const auto known = std::ranges::find(rigs_, type, &Rig::type);
  if (known != rigs_.end()) return known->kind;
  const anim::EntityKind* const own = body_->rigs.kind(type);
  if (own == nullptr) return Error{why_missing()};
  const Result<Kind> kind = add(*own);
  if (kind) rigs_.push_back({.type = type, .kind = *kind});
  return kind;
}

Result<std::uint32_t> OwnKinds::limb(Limb limb) const {
  const auto found = body_->rigs.limb(limb);
  if (!found) return Error{why_missing()};
  return *found;
}

Result<OwnKinds::Kind> OwnKinds::chain(const ChainReach& settings) {
  const Result<int> first = bone(settings.first);
  if (!first) return first.error();
  const Result<int> last = bone(settings.last);
  if (!last) return last.error();
  for (const Chains& known : chains_) {
    if (known.first == *first && known.last == *last) return known.kind;
  }
  const Result<anim::ReachChain> made = anim::make_reach_chain(skeleton(), *first, *last);
  if (!made) return made.error();
  Chains& chain = chains_.emplace_back(Chains{.first = *first, .last = *last, .chains = {*made}, .own = {}});
  chain.own = anim::chain_reach_kind(chain.chains);
  return add_last(chains_);
}

Result<OwnKinds::Kind> OwnKinds::springs(const Springs& settings) {
  std::string key = key_of(settings);
  const auto known = std::ranges::find(springs_, key, &SpringSet::key);
  if (known != springs_.end()) return known->kind;
  std::vector<anim::SpringChain> chains;
  for (const SpringChain& chain : settings.chains) {
    chains.push_back({.first = std::string(chain.first),
                      .last = std::string(chain.last),
                      .options = options_of(chain),
                      .tip = chain.tip});
  }
  std::vector<anim::SpringCollider> colliders;
  for (const SpringCollider& one : settings.colliders) {
    colliders.push_back(
        {.bone = std::string(one.bone), .from = to_glm(one.from), .to = to_glm(one.to), .radius = one.radius});
  }
  Result<anim::SpringRig> rig = anim::make_spring_rig(skeleton(), chains, colliders);
  if (!rig) return rig.error();
  SpringSet& set = springs_.emplace_back(SpringSet{.key = std::move(key), .rig = std::move(*rig), .own = {}});
  set.own = anim::spring_bones_kind(set.rig);
  return add_last(springs_);
}

Result<OwnKinds::Place> OwnKinds::socket(const Socket& settings) {
  if (settings.bone < 0 || settings.bone >= skeleton().bone_count()) {
    return Error{skeleton().name + ": a socket is at a bone, 0 to " + std::to_string(skeleton().bone_count() - 1)};
  }
  const Result<anim::SocketPlace> made =
      anim::make_socket_place(skeleton(), settings.bone, anim::to_joint(settings.offset));
  if (!made) return made.error();
  if (!socket_kind_) {
    socket_kind_ = anim::socket_kind(sockets_);
    const Result<Kind> kind = add(*socket_kind_);
    if (!kind) {
      socket_kind_.reset();
      return kind.error();
    }
    socket_number_ = *kind;
  }
  const auto is_same = [&](const anim::SocketPlace& place) {
    return place.chain.bones == made->chain.bones && place.offset.position == made->offset.position &&
           place.offset.rotation == made->offset.rotation;
  };
  const auto known = std::ranges::find_if(sockets_, is_same);
  const auto number = static_cast<std::uint32_t>(known - sockets_.begin());
  if (known == sockets_.end()) sockets_.push_back(*made);
  return Place{.kind = socket_number_, .number = number};
}

Result<std::uint32_t> OwnKinds::add_step(const StepKind& step) {
  if (const char* const fault = fault_of(step); fault != nullptr) return Error{fault};
  Step& own = steps_.emplace_back(Step{.step = step, .own = {}});
  own.own = step_entity_kind(own.step);
  if (const Result<Kind> kind = add_last(steps_, "Crowd::add_step"); !kind) return kind.error();
  return static_cast<std::uint32_t>(steps_.size() - 1);
}

std::optional<OwnKinds::Kind> OwnKinds::step(std::uint32_t number) const {
  return number < steps_.size() ? std::optional(steps_[number].kind) : std::nullopt;
}

}  // namespace throng::detail
