#version 450 core

// Adds what is seen through to two sums that do not depend on the order (McGuire and Bavoil, "Weighted Blended
// Order-Independent Transparency", 2013). crowd_cut_out.frag draws what has at least the alpha `solid_alpha`.
#include "frame_uniforms.glsl"
#include "lighting.glsl"
#include "shadows.glsl"
#include "lamps.glsl"
#include "crowd_surface.glsl"
#include "crowd_shading.glsl"
#include "crowd_material.glsl"
#include "crowd_emission.glsl"

layout(location = 2) uniform float solid_alpha;

layout(location = 0) out vec4 sum;      // of colours times alpha, and of alphas, by weight
layout(location = 1) out float hidden;  // share of what is behind

const float least_alpha = 1.0 / 255.0;

// Weighs what is near more than what is far behind it.
float weight_at(float metres) { return clamp(10.0 / (1e-3 + metres * metres * 0.04), 1e-2, 1e3); }

void main() {
  vec4 surface = surface_color();
  float weight = weight_at(distance(world_position, camera_position.xyz));
  sum = vec4(glowing(surface.rgb), 1.0) * (surface.a * weight);
  hidden = surface.a;
  if (surface.a >= solid_alpha || surface.a < least_alpha) discard;
}
