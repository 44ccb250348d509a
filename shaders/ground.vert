#version 450 core

#include "frame_uniforms.glsl"

out vec3 ray;

void main() {
  // One triangle that covers the picture: (-1, -1), (3, -1), (-1, 3).
  vec2 corner = vec2((gl_VertexID & 1) * 4 - 1, (gl_VertexID >> 1) * 4 - 1);
  ray = ray_forward.xyz + corner.x * ray_right.xyz + corner.y * ray_up.xyz;
  gl_Position = vec4(corner, 0.0, 1.0);
}
