#pragma once

#include <memory>
#include <span>

#include "app/commands/bench/crowd.h"
#include "engine/anim/agent/character_rigs.h"
#include "engine/anim/asset/model.h"

namespace throng::app {

/// The whole update over the same agents, each with a gaze and with noise on top of its clips. So it has a held
/// program, where the other subjects have streaming ones.
class HeldSubject {
 public:
  /// Returns null if nothing in the model can look, or if its agents do not fit the local store.
  static std::unique_ptr<HeldSubject> create(const anim::Model& model, std::shared_ptr<const anim::Character> character,
                                             const anim::SystemOptions& options, std::span<const BenchAgent> agents,
                                             const BenchPalettes& palettes);
  void run() { subject_->run(); }

 private:
  explicit HeldSubject(const anim::Model& model) : rigs_(model) {}
  bool add_processes(std::size_t agents);

  anim::CharacterRigs rigs_;
  std::unique_ptr<SystemSubject> subject_;
};

}  // namespace throng::app
