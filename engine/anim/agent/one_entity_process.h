#pragma once

#include <utility>

#include "engine/anim/agent/post_process.h"

namespace throng::anim {

/// A post process of one entity, which reads its `source`.
template <typename Entity>
class OneEntityProcess : public PostProcess {
 public:
  const char* fault(const EntityBuilder& build) const override {
    return build.has_kind(kind_, type()) ? nullptr : "its kind of entity was not added to this character";
  }
  Handle attach(const EntityBuilder& build, Handle source) final {
    if (!entity_.valid()) {
      entity_ = build.create(kind_);
      begin(build, entity_);
    }
    build.as<Entity>(entity_).source = source;
    return entity_;
  }
  void visit_handles(const std::function<void(Handle&)>& visit) final {
    if (entity_.valid()) visit(entity_);
  }
  void destroy_entities(const EntityBuilder& build) final {
    if (entity_.valid()) build.destroy(std::exchange(entity_, {}));
  }

 protected:
  explicit OneEntityProcess(EntityPools::Kind kind) : kind_(kind) {}
  OneEntityProcess(const OneEntityProcess&) = default;
  OneEntityProcess& operator=(const OneEntityProcess&) = default;

  /// Fills a new entity.
  virtual void begin(const EntityBuilder& build, Handle entity) = 0;

  Handle entity() const { return entity_; }
  /// Returns the data of its kind (EntityKind::resource).
  template <typename Resource>
  const Resource& resource(const EntityBuilder& build) const {
    return *static_cast<const Resource*>(build.pools().layout(kind_).kind->resource);
  }

 private:
  static constexpr EntityType type() {
    if constexpr (requires { Entity::entity_type; }) {
      return Entity::entity_type;
    } else {
      return EntityType::user;
    }
  }

  EntityPools::Kind kind_;
  Handle entity_;
};

}  // namespace throng::anim
