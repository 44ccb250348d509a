#pragma once

#include "tests/anim/agent/crowd_rig.h"

namespace throng::anim {

/// A crowd with every kind of entity in play. Each agent has one of eight graphs. They have fades that are interrupted,
/// layers with masks, post processes, kinds of the host's own (packets and whole poses), and sources that all share.
class EveryKind {
 public:
  static constexpr std::uint32_t agents = 48;

  explicit EveryKind(const SystemOptions& options = {});

  /// Makes frames with requests that depend on the frame alone. Some updates are skipped and some look ahead, at all
  /// levels.
  void step(int frames);

  AnimationSystem& operator*() const { return *system; }
  AnimationSystem* operator->() const { return system.get(); }
  std::unique_ptr<AnimationSystem> system;

 private:
  void request(std::uint32_t agent, std::uint32_t frame);
};

}  // namespace throng::anim
