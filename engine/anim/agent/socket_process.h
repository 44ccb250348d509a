#pragma once

#include "engine/anim/agent/one_entity_process.h"
#include "engine/anim/entity/socket.h"

namespace throng::anim {

/// Tells where an attachment is: a sword in a hand, a camera on a head. Add it after the processes that move the joint.
class SocketProcess final : public OneEntityProcess<Socket> {
 public:
  /// `kind` is socket_kind's, added to the system. `place` is an index of its SocketPlaces.
  SocketProcess(EntityPools::Kind kind, std::uint32_t place) : OneEntityProcess(kind), place_(place) {}

  /// Returns the motion at the agent's last update, in model space. If its bone level lacked a joint of the chain, the
  /// motion is from the last update that had all.
  JointMotion motion(const EntityPools& pools) const {
    return entity().valid() ? socket_motion(pools.as<Socket>(entity())) : JointMotion{};
  }

  const char* fault(const EntityBuilder& build) const override {
    if (const char* const no_kind = OneEntityProcess::fault(build); no_kind != nullptr) return no_kind;
    return place_ < resource<SocketPlaces>(build).size() ? nullptr : "place is not one of the kind's SocketPlaces";
  }
  std::unique_ptr<PostProcess> clone() const override { return std::make_unique<SocketProcess>(*this); }

 private:
  void begin(const EntityBuilder& build, Handle entity) override { build.as<Socket>(entity).place = place_; }

  std::uint32_t place_;
};

}  // namespace throng::anim
