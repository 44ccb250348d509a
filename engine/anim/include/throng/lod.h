#pragma once

#include "throng/crowd.h"
#include "throng/math.h"
#include "throng/standard.h"
#include "throng/ticks.h"

namespace throng {

/// The camera, as far as level of detail reads it.
struct Camera {
  Vec3 position{};                                ///< metres, world
  Vec3 forward{0.0F, 0.0F, -1.0F};                ///< unit
  std::array<std::array<float, 4>, 6> frustum{};  ///< unit normals and offsets, inside where normal * p + offset >= 0;
                                                  ///< all 0: every agent is in view
  float pixels_per_unit = 1000.0F;                ///< pixels that a metre covers at a distance of a metre
};

/// Makes a camera of a matrix from world to clip space, column-major as OpenGL has it, with z from -1 to 1.
Camera camera_of(const Vec3& position, const Vec3& forward, const float (&clip_from_world)[16], int pixels_tall);

enum class LodRule : unsigned char {
  off,       ///< every agent is posed every frame
  distance,  ///< the farther from the camera, the longer the interval between updates
  budget     ///< the cheapest choice whose predicted error on screen is within the limits
};

struct LodRules {
  LodRule rule = LodRule::budget;
  float error_pixels = 1.0F;         ///< budget: 99% of shown errors stay below it; 0: no limit
  double budget_milliseconds = 0.0;  ///< budget: of all PUs, a frame; 0: no limit
  float full_rate_distance = 12.0F;  ///< distance: metres up to which agents are posed every frame
  float interval_growth = 12.0F;     ///< distance: metres for each further frame of the interval
  int largest_interval = 8;          ///< frames, 1 to 16
  bool bone_lod = true;              ///< fewer bones far off
  bool smooth = false;               ///< the renderer blends each palette from the last one over its look-ahead
};

/// One frame of a crowd. The spans have an element for each agent, by its number; dead numbers' elements are not read.
struct LodFrame {
  std::span<const Vec3> positions{};  ///< metres, world, between the feet
  std::span<const float> scales{};    ///< empty: all 1
  Camera camera{};
  LodRules rules{};
  Ticks frame_step{};  ///< the time since the frame before
};

/// Decides which agents are posed now, how far ahead, and with how many bones (paper 3.2). It allocates only when
/// agents or characters are added, or rules change. Each call of a Lod that was moved from is a misuse (host.h).
///
///     for (PoseRequest& request : lod.select(crowd, frame)) request.palette = ...;
///     crowd.update(lod.requests());
///     lod.settle(crowd);
class Lod {
 public:
  Lod();
  ~Lod();
  Lod(Lod&&) noexcept;
  Lod& operator=(Lod&&) noexcept;

  /// Lists the agents to be posed. The span is valid until the next call.
  std::span<PoseRequest> select(Crowd& crowd, const LodFrame& frame);
  std::span<PoseRequest> requests();
  /// Learns the cost of the update.
  void settle(const Crowd& crowd);
  /// Makes an agent due in the next frame: after a request that must be seen at once.
  void make_due(AgentId agent);
  /// Returns whether the agent was in view in the last selection.
  bool is_visible(AgentId agent) const;

 private:
  struct State;
  bool is_gone(const char* call) const;
  void take_characters(const Crowd& crowd);
  void take_agents(const Crowd& crowd, const LodFrame& frame);
  void make_room(std::size_t numbers, const LodRules& rules);

  std::unique_ptr<State> state_;
};

}  // namespace throng
