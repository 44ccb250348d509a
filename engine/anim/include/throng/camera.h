#pragma once

#include "throng/math.h"
#include "throng/standard.h"

namespace throng {

/// The camera, as far as level of detail reads it.
struct Camera {
  Vec3 position{};                                ///< metres, world
  Vec3 forward{0.0F, 0.0F, -1.0F};                ///< unit
  std::array<std::array<float, 4>, 6> frustum{};  ///< unit normals and offsets, inside where normal * p + offset >= 0;
                                                  ///< all 0: every agent is in view
  float pixels_per_unit = 1000.0F;                ///< pixels that a metre covers at a distance of a metre
};

/// Makes a camera of a matrix from world to clip space, column-major as OpenGL has it. The matrix tells the range of
/// depths: from -1 to 1 or from 0 to 1, reversed or not, with a far plane or without. A camera without one has a far
/// plane of zeros, which holds everything.
/// Depths from 0 to 1 that are not reversed look like depths from -1 to 1 whose near plane is half as far: the camera
/// has that near plane. An orthographic matrix is taken for one with depths from -1 to 1, which holds at least as much.
Camera camera_of(const Vec3& position, const Vec3& forward, const float (&clip_from_world)[16], int pixels_tall);
Camera camera_of(const Vec3& position, const Vec3& forward, const Mat4& clip_from_world, int pixels_tall);

/// Moves the planes of a camera outwards, so that agents outside are in view whose shadows may fall into the picture.
/// `to_light` is a unit vector; `height` is the tallest agent's. A shadow that falls farther than eight times the
/// height is faint, and not looked for.
void include_casters(Camera& camera, const Vec3& to_light, float height);

}  // namespace throng
