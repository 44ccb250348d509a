#pragma once

#include <memory>
#include <span>
#include <vector>

#include "app/commands/bench/crowd.h"

namespace throng::app {

/// Says where a host reads the place of a hand.
enum class SocketSource : unsigned char {
  palette,  ///< in the palette that was just written, as a draw of things does on a device
  list      ///< in a joint that the update writes beside the palette, where palettes cannot be read back
};

/// The whole update over the same agents, some of which carry a thing in a hand. After it, the host multiplies the hand
/// with the agent's place, as the matrix of an instance.
class SocketSubject {
 public:
  /// Returns null if the agents do not fit the local store. `things` is at most the number of agents; the carriers are
  /// spread over all. `palettes` are matrices.
  static std::unique_ptr<SocketSubject> create(std::shared_ptr<const anim::Character> character,
                                               const anim::SystemOptions& options, std::span<const BenchAgent> agents,
                                               const BenchPalettes& palettes, std::size_t things, SocketSource source);
  void run();

 private:
  /// Three rows of four, as an instanced draw reads them.
  struct alignas(16) Matrix {
    float rows[12];
  };
  struct Carrier {
    const float* hand;  ///< three rows of four, in model space
    float x, z, cosine, sine;
  };

  std::unique_ptr<SystemSubject> subject_;
  float from_hand_[3] = {};  // where the joint is in the space of the matrix at `hand`
  std::vector<Carrier> carriers_;
  std::vector<Matrix> listed_;     // [thing] of a list of joints
  std::vector<Matrix> instances_;  // [thing] in the world
};

/// Returns the joint of the right hand, or the last joint where the hand is unknown.
int carrying_joint(const anim::Skeleton& skeleton);

}  // namespace throng::app
