#version 450 core

#include "frame_uniforms.glsl"
#include "ribbon.glsl"

layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 color;

layout(location = 0) uniform vec2 picture;  // pixels

const float half_width = 1.0;  // pixels
const float feather = 0.75;

out vec4 passed_color;
out float pixels_from_middle;

void main() {
  vec4 a = view_projection * vec4(from, 1.0), b = view_projection * vec4(to, 1.0);
  passed_color = color;
  pixels_from_middle = 0.0;
  gl_Position = vec4(2.0, 2.0, 0.0, 1.0);  // outside
  if (is_behind(a, b)) return;
  vec4 first = clipped(a, b), last = clipped(b, a);
  vec2 along = way_between(first, last, picture);
  if (dot(along, along) < 1e-6) return;
  int corner = gl_VertexID < 3 ? gl_VertexID : 6 - gl_VertexID;  // 0 1 2, 3 2 1
  pixels_from_middle = ((corner & 1) == 0 ? -1.0 : 1.0) * (half_width + feather);
  gl_Position = shifted(corner < 2 ? first : last, turned_left(along) * pixels_from_middle, picture);
}
