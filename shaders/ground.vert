#version 450 core

// The town's rectangle on the plane y = 0, or all of the picture below the horizon, which is level, as the camera is.
// Its depth is the farthest, so that it is hidden by all that stands.
#include "frame_uniforms.glsl"

layout(location = 1) uniform vec2 half_sides;  // of the town, metres
layout(location = 2) uniform bool below_horizon;

void main() {
  vec2 corner = 2.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1.0;
  vec2 place = corner * half_sides;
  gl_Position = view_projection * vec4(place.x, 0.0, place.y, 1.0);
  if (below_horizon) {
    float horizon = clamp(-ray_forward.y / ray_up.y, -1.0, 1.0);
    gl_Position = vec4(corner.x, mix(-1.0, horizon, 0.5 + 0.5 * corner.y), 0.0, 1.0);
  }
  gl_Position.z = 0.0;
}
