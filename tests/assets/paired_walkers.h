#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/agent/character_rigs.h"

namespace throng::test {

/// The built-in character twice, side by side on flat ground: once with its feet placed, once as its clips have it.
/// Both get the same requests and move by their root motion.
class PairedWalkers {
 public:
  static constexpr std::size_t leg_count = 2;

  /// One leg in the world, metres.
  struct Leg {
    glm::vec3 ankle;
    glm::vec3 ball;
    float sole;  // height of its lowest point
  };
  struct Body {
    float hips;  // height
    std::array<Leg, leg_count> legs;
  };
  struct Pair {
    Body placed;
    Body clip;
  };

  explicit PairedWalkers(std::size_t pairs);

  static const anim::Character& character();
  /// Asks the same of both agents of a pair.
  void ask(std::size_t pair, const std::function<void(anim::Agent)>& request);
  void play(std::size_t pair, const anim::PlayRequest& request) {
    ask(pair, [&](anim::Agent agent) { agent.play(request); });
  }
  /// Makes a frame at 60 Hz and returns how the pairs stand then.
  const std::vector<Pair>& step();

 private:
  Body body(std::uint32_t agent, const anim::JointMotion& placement) const;

  std::unique_ptr<anim::AnimationSystem> system_;
  std::vector<anim::JointMotion> placements_;  // [pair]
  std::vector<PoseRequest> updates_;
  std::vector<Pair> pairs_;
};

/// Watches pairs from frame to frame. All is in metres.
struct WalkFigures {
  float most_drop = 0.0F;        // of the hips below the clip's
  float most_extra_step = 0.0F;  // of an ankle in a frame, beyond the clip's
  double slid = 0.0;             // by balls of feet that stand, over the ground
  double slid_in_clip = 0.0;     // by the same feet as the clip has them

  void add(const PairedWalkers::Pair& before, const PairedWalkers::Pair& now);
};

}  // namespace throng::test
