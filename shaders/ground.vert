#version 450 core

// The town's rectangle on the plane y = 0, or all of the picture below the horizon, which is level, as the camera is.
// All that stands hides it: only the sky is farther away.
#include "frame_uniforms.glsl"
#include "lighting.glsl"

layout(location = 1) uniform vec2 half_sides;  // of the town, metres
layout(location = 2) uniform bool below_horizon;

const float town_depth = 2e-20, fields_depth = 1e-20;

// The light of the sun and of the sky that a white ground reflects is the same everywhere.
flat out vec3 light_of_sun;
flat out vec3 light_of_sky;

void main() {
  light_of_sun = sun_light() * to_sun.y;
  light_of_sky = ambient_light(vec3(0.0, 1.0, 0.0));
  vec2 corner = 2.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1.0;
  vec2 place = corner * half_sides;
  gl_Position = view_projection * vec4(place.x, 0.0, place.y, 1.0);
  if (below_horizon) {
    float horizon = clamp(-ray_forward.y / ray_up.y, -1.0, 1.0);
    gl_Position = vec4(corner.x, mix(-1.0, horizon, 0.5 + 0.5 * corner.y), 0.0, 1.0);
  }
  gl_Position.z = (below_horizon ? fields_depth : town_depth) * gl_Position.w;
}
