#version 450 core

#include "crowd_surface.glsl"

layout(location = 2) uniform float alpha_cutoff;

void main() {
  if (surface_color().a < alpha_cutoff) discard;
}
