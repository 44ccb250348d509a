#version 450 core

#ifdef CUT_OUT
#include "crowd_surface.glsl"

layout(location = 2) uniform float alpha_cutoff;
#endif

#ifdef ALONE
flat in ivec4 cell;
#else
flat in uint label;
#endif

layout(location = 0) out uint number;

void main() {
#ifdef ALONE
  ivec2 place = ivec2(gl_FragCoord.xy);
  bool is_outside = any(lessThan(place, cell.xy)) || any(greaterThanEqual(place, cell.zw));
  number = 1u;
#else
  bool is_outside = false;
  number = label;
#endif
#ifdef CUT_OUT
  is_outside = surface_color().a < alpha_cutoff || is_outside;
#endif
  if (is_outside) discard;  // last, so that neighbours find the slopes of what they read
}
