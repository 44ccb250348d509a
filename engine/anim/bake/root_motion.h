#pragma once

#include <glm/vec3.hpp>

#include "engine/anim/asset/keyframe_stream_clip.h"
#include "engine/anim/asset/root_curve.h"

namespace throng::anim {

/// Returns the curve of the root motion that baking takes out of a clip; without keys where there is none. A character
/// of 1.8 m has the size 1.
///
/// - It travels over the ground as the topmost moving bone that carries most of the skeleton does, from the clip's
/// start
///   to its end, if that is more than 5 cm.
/// - It turns by as much as a bone that carries most of the skeleton turns about +Y from start to end, if the last
/// pose,
///   turned back, closes to 5 mm and the turn is above 3 degrees, or if it is above 20 degrees and no joint stays away:
///   turned back, each comes to within half of its distance or 3 cm. So a walk that sways and a body that twists over
///   its feet do not turn. Nor does a body that spins by more than 270 degrees, as in an attack.
/// - It climbs under the same terms, above 5 cm or 10 cm. A person who sits down does not climb: the feet stay.
///
/// The curve is steady: one speed, and one rate of turning. There is none where a root moves in steps, from which
/// nothing can be taken out, and no turn where the nodes above a root shear or scale unevenly.
RootCurve find_root_motion(const Skeleton& skeleton, const StateClip& clip, double size);

/// Takes `travel` * time / duration out of every root bone, so that the whole skeleton comes along.
void take_root_motion(const Skeleton& skeleton, StateClip& clip, const glm::dvec3& travel);

/// Returns the clip without the motion of a curve that turns. Root bones get linear keys, `step` seconds apart. `start`
/// is the file's time at the curve's start. A bone that rotates between keys while the root turns is off by a little.
Clip without_root_motion(const Skeleton& skeleton, const Clip& clip, const RootCurve& curve, double start, double step);

/// Returns the travel that was taken out of the tracks of a clip in place of such keys: 0 for curves that turn.
glm::dvec3 straight_travel(const RootCurve& curve);

/// Converts `travel` to the space of a root bone's state position.
glm::dvec3 drift_of_root(const Skeleton& skeleton, int bone, const glm::dvec3& travel);

}  // namespace throng::anim
