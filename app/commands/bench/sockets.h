#pragma once

#include <memory>
#include <span>
#include <vector>

#include "app/commands/bench/crowd.h"

namespace throng::app {

/// The whole update over the same agents, some of which carry a thing in a hand: their update writes the joint of the
/// hand beside the palette, and the host multiplies it with the agent's place, as the matrix of an instance.
class SocketSubject {
 public:
  /// Returns null if the agents do not fit the local store. `things` is at most the number of agents; the carriers are
  /// spread over all.
  static std::unique_ptr<SocketSubject> create(std::shared_ptr<const anim::Character> character,
                                               const anim::SystemOptions& options, std::span<const BenchAgent> agents,
                                               const BenchPalettes& palettes, std::size_t things);
  void run();

 private:
  /// Three rows of four, as an instanced draw reads them.
  struct alignas(16) Matrix {
    float rows[12];
  };
  struct Place {
    float x, z, cosine, sine;
  };

  std::unique_ptr<SystemSubject> subject_;
  std::vector<Place> places_;      // [thing] of the agent that carries it
  std::vector<Matrix> hands_;      // [thing] in model space
  std::vector<Matrix> instances_;  // [thing] in the world
};

/// Returns the joint of the right hand, or the last one where no bone is known as that.
int carrying_joint(const anim::Skeleton& skeleton);

}  // namespace throng::app
