#pragma once

#include <array>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "engine/anim/asset/skeleton.h"
#include "engine/anim/retarget/figure.h"
#include "engine/anim/retarget/rig_match.h"

namespace throng::anim {

/// A bone that follows another: its rotation is turn * source's rotation * from_source, model space.
struct FollowedBone {
  int source = -1;                               ///< bone of the other skeleton; -1: the bone keeps its rest transform
  glm::dquat from_source{1.0, 0.0, 0.0, 0.0};    ///< through both reference poses
  int source_parent = -1;                        ///< parent of `source`, if our parent follows it, ...
  glm::dvec3 source_offset{0.0};                 ///< ... and the way from it in the reference pose, in its frame
  bool carries_hips = false;                     ///< stands above the hips: its place moves too, scaled
  glm::dvec3 source_place{0.0}, own_place{0.0};  ///< both reference poses, of a bone that carries the hips
};

/// One leg that is kept on the ground.
struct FollowedLeg {
  LimbBones own;                            ///< bones of the skeleton that follows
  LimbBones source;                         ///< bones of the other; the ends of both exist
  std::array<glm::dvec3, 2> own_sole{};     ///< heel and ball from the ankle, in the frame of the foot bone
  std::array<glm::dvec3, 2> source_sole{};  ///< the same of the other
  glm::dvec3 shin{0.0};                     ///< from our knee to our ankle, in the frame of the knee's bone
  glm::dvec3 wider{0.0};  ///< our hip joint from the middle of both, less the scaled one of the source, level
  glm::dquat own_foot{1.0, 0.0, 0.0, 0.0};  ///< our foot in its reference pose
};

/// Everything that retargeting knows of two skeletons. Read-only; one serves all clips.
struct RetargetPlan {
  std::vector<FollowedBone> bones;      ///< one a bone of the skeleton that follows
  glm::dquat turn{1.0, 0.0, 0.0, 0.0};  ///< quarter turns about the vertical, from one's forward to the other's
  double scale = 1.0;                   ///< leg length over leg length
  glm::dvec3 source_origin{0.0};        ///< on the ground below the hips, or the origin where that is near
  glm::dvec3 own_origin{0.0};
  int hips = -1;                          ///< bone that is placed by the hip joints; -1 without hips or legs
  glm::dvec3 hips_to_joints{0.0};         ///< from it to the middle of its hip joints, in its own frame
  std::array<int, 2> own_joints{-1, -1};  ///< hip joints, left and right
  std::array<int, 2> source_joints{-1, -1};
  std::vector<FollowedLeg> legs;
  glm::dvec3 forward_in_hips{0.0, 0.0, 1.0};  ///< where the skeleton that follows faces, in the frame of its hips
  double leg_length = 1.0;                    ///< its thigh and shin with the height of the ankle, metres
  Carriage own_carriage = Carriage::unknown;
  Carriage source_carriage = Carriage::unknown;
};

RetargetPlan plan_retarget(const Skeleton& from, const Skeleton& to, const RigMatch& match);

}  // namespace throng::anim
