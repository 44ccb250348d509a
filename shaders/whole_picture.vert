#version 450 core

void main() {
  // One triangle that covers the picture: (-1, -1), (3, -1), (-1, 3).
  gl_Position = vec4((gl_VertexID & 1) * 4 - 1, (gl_VertexID >> 1) * 4 - 1, 0.0, 1.0);
}
