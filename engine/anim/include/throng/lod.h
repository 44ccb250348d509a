#pragma once

#include "throng/camera.h"
#include "throng/crowd.h"
#include "throng/lod_rules.h"
#include "throng/math.h"
#include "throng/standard.h"
#include "throng/ticks.h"

namespace throng {

/// One frame of a crowd. The spans have an element for each agent, by its number; dead numbers' elements are not read.
struct LodFrame {
  std::span<const Vec3> positions{};  ///< metres, world, between the feet
  std::span<const float> scales{};    ///< empty: all 1
  Camera camera{};
  LodRules rules{};
  Ticks frame_step{};  ///< the time since the frame before
};

/// Decides which agents are posed now, how far ahead, and with how many bones (paper 3.2). It allocates only when
/// agents or characters are added, or rules change. Each call of a Lod that was moved from is a misuse (host.h). A copy
/// that is kept beside a snapshot of the crowd goes on to the same choices, once the crowd is restored.
///
///     for (PoseRequest& request : lod.select(crowd, frame)) request.palette = ...;
///     crowd.update(lod.requests());
///     lod.settle(crowd);
class Lod {
 public:
  Lod();
  ~Lod();
  Lod(const Lod& other);
  Lod& operator=(const Lod& other);
  Lod(Lod&&) noexcept;
  Lod& operator=(Lod&&) noexcept;

  /// Lists the agents to be posed. The span is valid until the next call.
  std::span<PoseRequest> select(Crowd& crowd, const LodFrame& frame);
  std::span<PoseRequest> requests();
  /// Learns the cost of the update.
  void settle(const Crowd& crowd);
  /// Makes an agent due in the next frame, as a request for a clip does by itself: after another request that must be
  /// seen at once.
  void make_due(AgentId agent);
  /// Returns whether the agent was in view in the last selection.
  bool is_visible(AgentId agent) const;

 private:
  struct State;
  bool is_gone(const char* call) const;
  void take_characters(const Crowd& crowd);

  std::unique_ptr<State> state_;
};

}  // namespace throng
