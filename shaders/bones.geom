#version 450 core
// A bone as a ribbon, from its joint to the joint of its parent, where it is wider. It has a dark edge.

#include "ribbon.glsl"

layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;

layout(location = 2) uniform vec2 picture;  // pixels

const float share_of_length = 0.055;
const float narrowest = 0.35, widest = 2.75;  // half a width, in pixels
const float taper = 0.4;                      // the narrow end over the wide one
const float edge = 1.75;                      // pixels beyond the bone, for the dark edge and for smoothness

noperspective out float pixels_from_middle;
noperspective out float half_width;

void put(vec4 end, vec2 across, float own_half) {
  for (float side = -1.0; side <= 1.0; side += 2.0) {
    half_width = own_half;
    pixels_from_middle = side * (own_half + edge);
    gl_Position = shifted(end, across * pixels_from_middle, picture);
    EmitVertex();
  }
}

void main() {
  vec4 a = gl_in[0].gl_Position, b = gl_in[1].gl_Position;
  if (is_behind(a, b)) return;
  vec4 joint = clipped(a, b), parent = clipped(b, a);
  vec2 along = way_between(joint, parent, picture);
  float pixels = 0.5 * length(along);
  if (pixels < 1e-3) return;
  float wide = clamp(share_of_length * pixels, narrowest, widest);
  vec2 across = turned_left(along);
  put(joint, across, max(taper * wide, narrowest));
  put(parent, across, wide);
  EndPrimitive();
}
