#pragma once

#include <memory>
#include <span>

#include "app/commands/bench/crowd.h"

namespace throng::app {

/// The whole update over the same agents, for a host that draws nothing: listed joints and no palettes.
class JointSubject {
 public:
  /// Returns null if the skeleton has no such joints, or if its agents do not fit the local store.
  static std::unique_ptr<JointSubject> create(std::shared_ptr<const anim::Character> character,
                                              const anim::SystemOptions& options, std::span<const BenchAgent> agents,
                                              const BenchPalettes& palettes, const anim::JointList& list,
                                              JointFormat format);
  void run() { subject_->run(); }

 private:
  std::unique_ptr<SystemSubject> subject_;
  anim::AlignedBytes memory_;
};

/// Lists three joints, as a game asks for sockets: at a half, at three quarters and at the end of the skeleton's order.
anim::JointList three_joints(const anim::Skeleton& skeleton);

}  // namespace throng::app
