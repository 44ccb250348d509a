#include "engine/anim/bake/clip_in_place.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <glm/gtc/quaternion.hpp>

#include "engine/anim/bake/grid.h"
#include "engine/anim/bake/root_motion.h"
#include "engine/anim/bake/still_tracks.h"
#include "engine/anim/base/elementary.h"

namespace throng::anim {

namespace {

constexpr double turn_error = 0.00001;  // metres of a person: the error of turned keys in between
constexpr double usual_rate = 30.0;     // Hz, of keys on no grid
constexpr int finest = 8;               // keys for each of before

BoneFrame moved(const RootMotion& motion, const BoneFrame& frame) {
  const glm::dmat3 turn = glm::mat3_cast(angle_axis(motion.yaw, glm::dvec3(0.0, 1.0, 0.0)));
  return {.axes = turn * frame.axes, .origin = turn * frame.origin + motion.translation};
}

/// Returns how far a clip in place and its curve together are off the clip, in metres on the surface.
double clip_distance(const Skeleton& skeleton, const SurfaceProxy& proxy, const StateClip& clip,
                     const StateClip& in_place, const RootCurve& curve) {
  constexpr double looks_a_second = 137.0;  // on and between keys of any rate
  const AlignedBytes from = pack_keyframe_stream(clip), to = pack_keyframe_stream(in_place);
  ExactPoses expected(*reinterpret_cast<const KeyframeStream*>(from.get()));
  ExactPoses placed(*reinterpret_cast<const KeyframeStream*>(to.get()));
  std::vector<BoneFrame> before(skeleton.bones.size()), after(skeleton.bones.size());
  const auto looks = static_cast<std::int64_t>(std::clamp(to_seconds(clip.duration) * looks_a_second, 32.0, 4000.0));
  double worst = 0.0;
  for (std::int64_t i = 0; i <= looks; ++i) {
    const Ticks time = clip.duration * i / looks;
    compute_frames(skeleton, expected.at(time), before);
    compute_frames(skeleton, placed.at(time), after);
    const RootMotion motion = displacement(curve, 0, time * fine_ticks_per_tick, false);
    for (BoneFrame& frame : after) frame = moved(motion, frame);
    worst = std::max(worst, largest_distance(proxy, before, after));
  }
  return worst;
}

struct Turned {
  Clip clip;
  StateClip state;
  double error = 0.0;
};

/// Takes a turn out with as few keys as keep to the error: keys of the clip's own grid, or some of them.
Turned turned_back(const Skeleton& skeleton, const SurfaceProxy& proxy, const Clip& clip, const RootCurve& curve,
                   double start) {
  const StateClip state = to_state_space(skeleton, clip, start);
  const std::vector<Ticks> keys = key_times(state);
  const std::optional<KeyGrid> grid = keys.empty() ? std::nullopt : find_grid(keys, start);
  const double step = 1.0 / (grid ? grid->rate : usual_rate);
  Turned turned;
  for (int parts = 1; parts <= finest; parts *= 2) {
    turned.clip = without_root_motion(skeleton, clip, curve, start, step / parts);
    turned.state = to_state_space(skeleton, turned.clip, start);
    turned.error = clip_distance(skeleton, proxy, state, turned.state, curve);
    if (turned.error <= turn_error * proxy.height / tall_person) break;
  }
  return turned;
}

}  // namespace

Clip without_turn(const Skeleton& skeleton, const SurfaceProxy& proxy, const Clip& clip, const RootCurve& curve,
                  double start) {
  return turned_back(skeleton, proxy, clip, curve, start).clip;
}

ClipInPlace put_in_place(const Skeleton& skeleton, const SurfaceProxy& proxy, const Clip& clip,
                         const PlacingOptions& options) {
  const auto hold = [&](StateClip& state) {
    return options.still > 0.0 ? hold_still_tracks(skeleton, proxy, options.still, state) : 0.0;
  };
  ClipInPlace placed{.state = to_state_space(skeleton, clip, options.start), .root_motion = {}, .keys = {}};
  placed.error = hold(placed.state);
  placed.keys = key_times(placed.state);
  placed.root_motion.duration = placed.state.duration;
  if (!options.take_root_motion) return placed;
  placed.root_motion = find_root_motion(skeleton, placed.state, proxy.height / tall_person);
  if (turns(placed.root_motion)) {
    Turned turned = turned_back(skeleton, proxy, clip, placed.root_motion, options.start);
    placed.state = std::move(turned.state);
    placed.error = turned.error + hold(placed.state);
    placed.keys = key_times(placed.state);
    return placed;
  }
  const glm::dvec3 travel = straight_travel(placed.root_motion);
  if (travel != glm::dvec3(0.0)) take_root_motion(skeleton, placed.state, travel);
  return placed;
}

}  // namespace throng::anim
