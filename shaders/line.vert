#version 450 core

#include "frame_uniforms.glsl"

layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 color;

layout(location = 0) uniform vec2 picture;  // pixels

const float half_width = 1.0;  // pixels
const float feather = 0.75;
const float least_w = 0.06;  // in front of the near plane

out vec4 passed_color;
out float pixels_from_middle;

// Finds where the line from `inside` to `outside` leaves the space in front of the camera.
vec4 clipped(vec4 outside, vec4 inside) {
  return outside.w >= least_w ? outside : mix(outside, inside, (least_w - outside.w) / (inside.w - outside.w));
}

void main() {
  vec4 a = view_projection * vec4(from, 1.0), b = view_projection * vec4(to, 1.0);
  passed_color = color;
  pixels_from_middle = 0.0;
  gl_Position = vec4(2.0, 2.0, 0.0, 1.0);  // outside
  if (max(a.w, b.w) < least_w) return;
  vec4 first = clipped(a, b), last = clipped(b, a);
  vec2 along = (last.xy / last.w - first.xy / first.w) * picture;
  if (dot(along, along) < 1e-6) return;
  vec2 across = normalize(vec2(-along.y, along.x));
  int corner = gl_VertexID < 3 ? gl_VertexID : 6 - gl_VertexID;  // 0 1 2, 3 2 1
  pixels_from_middle = ((corner & 1) == 0 ? -1.0 : 1.0) * (half_width + feather);
  gl_Position = corner < 2 ? first : last;
  gl_Position.xy += 2.0 * across * pixels_from_middle / picture * gl_Position.w;
}
