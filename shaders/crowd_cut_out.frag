#version 450 core

#include "frame_uniforms.glsl"
#include "lighting.glsl"
#include "shadows.glsl"
#include "lamps.glsl"
#include "crowd_surface.glsl"
#include "crowd_shading.glsl"
#include "crowd_material.glsl"
#include "crowd_emission.glsl"

layout(location = 2) uniform float alpha_cutoff;

out vec4 color;

void main() {
  vec4 surface = surface_color();
  color = vec4(glowing(surface.rgb), 1.0);
  if (surface.a < alpha_cutoff) discard;  // last, so that neighbours find the slopes of what they read
}
