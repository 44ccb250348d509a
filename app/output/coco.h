#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include <glm/vec3.hpp>

#include "app/character/source.h"

namespace throng::app {

/// The points of a person that the data set COCO names, in its order.
inline constexpr std::array<std::string_view, 17> coco_names{
    "nose",           "left_eye",   "right_eye",   "left_ear",   "right_ear",   "left_shoulder",
    "right_shoulder", "left_elbow", "right_elbow", "left_wrist", "right_wrist", "left_hip",
    "right_hip",      "left_knee",  "right_knee",  "left_ankle", "right_ankle"};
inline constexpr std::size_t coco_face_points = 5;  ///< the first ones; they are guessed

/// Where a point of COCO is: carried by a bone, at a place in the bone's own frame.
struct CocoPoint {
  int bone = -1;  ///< -1: the character has no such point
  glm::vec3 place{0.0F};
};
using CocoPoints = std::array<CocoPoint, coco_names.size()>;

/// Finds the points on a character. Joints come of the rig map (anim::find_rig). Nose, eyes and ears follow from the
/// shape of the surface that the head's bones carry: the nose is its foremost point in the middle, and the others lie
/// beside it as on people. A skeleton that is not rigid, or has no head or no surface, has none of these five.
CocoPoints coco_points(const CharacterSource& source);

}  // namespace throng::app
