#pragma once

#include "throng/ids.h"
#include "throng/math.h"
#include "throng/standard.h"
#include "throng/ticks.h"

/// Requests to the channels of an agent, and settings of new channels. A call reads spans while it lasts.
namespace throng {

/// "Play this clip."
struct Play {
  ClipId clip{};
  Ticks fade{};        ///< eases in from what plays now; 0 replaces it at once
  double speed = 1.0;  ///< multiple of the clip's own speed, below 32,768; negative: backwards
  Ticks start{};       ///< position in the clip, 0 to its duration
  bool loop = true;
  MaskId mask{};  ///< lays the clip over what plays now, on these bones, until a request without a mask
  /// Where the agent stands in a cut scene; it moves on from here by the clip's own root motion.
  std::optional<Place> absolute_root = std::nullopt;
};

/// "Play this clip once, over what plays." It is for slots (Agent::add_slot).
struct OneShot {
  ClipId clip{};
  Ticks fade_in{};      ///< eases in from what is shown; 0 replaces it at once
  Ticks fade_out{};     ///< eases out, so that the fade ends with the clip
  double speed = 1.0;   ///< multiple of the clip's own speed, not 0; negative: backwards, from the clip's end
  bool queued = false;  ///< it waits for the clips before it, and eases in over the end of the last
};

/// How a channel lies over the channels before it.
struct Layer {
  float weight = 1.0F;  ///< 0 to 1
  MaskId mask{};
};

/// Says whether a clip of a blend space keeps step with the others.
enum class Pace : unsigned char {
  automatic,  ///< a gait if it has a speed over ground
  gait,       ///< it keeps step with the other gaits, foot by foot
  own         ///< it plays at its own rate
};

/// A clip, and the value of the parameter at which it is played alone.
struct BlendPoint {
  ClipId clip{};
  float parameter = 0.0F;
  Pace pace = Pace::automatic;
};

/// Clips along one parameter, such as idle, walk, jog and run by speed. Two neighbours of the parameter are blended.
struct BlendSpace {
  std::span<const BlendPoint> points{};  ///< at least one; parameters ascend
  float parameter = 0.0F;
  /// Metres a second: the root moves at the parameter, so that feet do not slide, where the parameter of each point is
  /// the speed at which its clip was made (ClipInfo::ground_speed). Beyond the last point its clip plays faster. Clips
  /// without root motion move no root (LoadOptions::walk_in_place).
  bool is_ground_speed = true;
};

/// A clip, and the place in the plane at which it is played alone.
struct BlendPoint2d {
  ClipId clip{};
  float x = 0.0F;
  float y = 0.0F;
  Pace pace = Pace::automatic;
};

/// Says what the parameters of a plane are, and so the speed over ground of a point.
enum class PlaneMeaning : unsigned char {
  plain,          ///< no speed: each clip keeps its own
  velocity,       ///< metres a second, aside and ahead
  speed_and_turn  ///< x is the speed, in metres a second; y is anything, such as a rate of turning
};

/// Clips in a plane of two parameters. The points of the triangle around them are blended.
struct BlendSpace2d {
  std::span<const BlendPoint2d> points{};  ///< at least one, none twice
  PlaneMeaning meaning = PlaneMeaning::velocity;
  float x = 0.0F;
  float y = 0.0F;
};

}  // namespace throng
