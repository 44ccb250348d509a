#pragma once

#include <utility>

#include "engine/anim/agent/channel.h"

namespace throng::anim {

/// Plays one clip; the next clip takes its place at once.
class SimpleChannel final : public Channel {
 public:
  explicit SimpleChannel(const PlayerStart& start) : start_(start) {}

  void play(const PlayerStart& start) {
    start_ = start;
    starts_ = true;
  }

  const char* fault(const EntityBuilder& build) const override { return build.fault_of(start_); }
  Handle state() const override { return player_; }
  bool update(const EntityBuilder& build) override {
    if (!std::exchange(starts_, false)) return false;
    destroy_entities(build);
    player_ = build.player(start_);
    return true;
  }
  void visit_handles(const std::function<void(Handle&)>& visit) override {
    if (player_.valid()) visit(player_);
  }
  void destroy_entities(const EntityBuilder& build) override {
    if (player_.valid()) build.destroy(std::exchange(player_, {}));
  }
  std::unique_ptr<Channel> clone() const override { return std::make_unique<SimpleChannel>(*this); }

 private:
  PlayerStart start_;
  bool starts_ = true;
  Handle player_;
};

}  // namespace throng::anim
