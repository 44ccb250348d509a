#pragma once

#include <utility>

#include "engine/anim/agent/post_process.h"
#include "engine/anim/entity/socket.h"

namespace throng::anim {

/// Tells where an attachment is: a sword in a hand, a camera on a head. Added after the processes that move the joint.
class SocketProcess final : public PostProcess {
 public:
  /// `kind`: of socket_kind, added to the system; `place`: index of its SocketPlaces.
  SocketProcess(EntityPools::Kind kind, std::uint32_t place) : kind_(kind), place_(place) {}

  /// Model space, of the agent's last update; where its bone level lacked a joint of the chain, of the last that had
  /// all.
  JointMotion motion(const EntityPools& pools) const {
    return entity_.valid() ? socket_motion(pools.as<Socket>(entity_)) : JointMotion{};
  }

  Handle attach(const EntityBuilder& build, Handle source) override {
    if (!entity_.valid()) {
      entity_ = build.create(kind_);
      build.as<Socket>(entity_).place = place_;
    }
    build.as<Socket>(entity_).source = source;
    return entity_;
  }
  void visit_handles(const std::function<void(Handle&)>& visit) override {
    if (entity_.valid()) visit(entity_);
  }
  void destroy_entities(const EntityBuilder& build) override {
    if (entity_.valid()) build.destroy(std::exchange(entity_, {}));
  }
  std::unique_ptr<PostProcess> clone() const override { return std::make_unique<SocketProcess>(*this); }

 private:
  EntityPools::Kind kind_;
  std::uint32_t place_;
  Handle entity_;
};

}  // namespace throng::anim
