#version 450 core

#include "frame_uniforms.glsl"
#include "crowd_surface.glsl"
#include "shadow_darkening.glsl"

layout(location = 2) uniform float alpha_cutoff;

out vec4 darkening;

void main() {
  if (surface_color().a < alpha_cutoff) discard;
  darkening = shadow_darkening();
}
