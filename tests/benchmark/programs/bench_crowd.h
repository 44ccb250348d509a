#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "app/commands/bench/crowd.h"

namespace throng::app {

/// Agents of one character, memory for their palettes, and the system that updates them.
struct BenchCrowd {
  std::vector<BenchAgent> agents;
  BenchPalettes palettes;
  SystemSubject subject;

  static Result<BenchCrowd> create(std::shared_ptr<const anim::Character> character, const anim::SystemOptions& options,
                                   std::vector<BenchAgent> agents) {
    BenchPalettes palettes(static_cast<int>(agents.size()), character->skeleton.palette_count());
    auto subject = SystemSubject::create(std::move(character), options, agents, palettes);
    if (!subject) return subject.error();
    return BenchCrowd{std::move(agents), std::move(palettes), std::move(*subject)};
  }
  const anim::AnimationSystem& system() const { return subject.system(); }
};

}  // namespace throng::app
