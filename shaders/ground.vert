#version 450 core

// A part of the plane y = 0: the rectangle around the town, or one of four around that as far as one sees. Its depth is
// the farthest, so that it is hidden by all that stands.
#include "frame_uniforms.glsl"

layout(location = 1) uniform vec2 half_sides;  // of the town, metres
layout(location = 2) uniform bool outside;

const float as_far_as_one_sees = 60000.0;  // metres

void main() {
  vec2 corner = 2.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1.0;
  vec2 place = corner * half_sides;
  if (outside) {
    // Two strips along the whole of x, and two between them.
    bool strip = gl_InstanceID < 2;
    float side = (gl_InstanceID & 1) == 0 ? -1.0 : 1.0;
    vec2 inner = half_sides, far = vec2(as_far_as_one_sees);
    float from_middle = 0.5 + 0.5 * corner.x;
    place = strip ? vec2(corner.y * far.x, side * mix(inner.y, far.y, from_middle))
                  : vec2(side * mix(inner.x, far.x, from_middle), corner.y * inner.y);
  }
  gl_Position = view_projection * vec4(place.x, 0.0, place.y, 1.0);
  gl_Position.z = 0.0;
}
