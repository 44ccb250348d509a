#version 450 core

layout(location = 0) in vec2 position;
layout(location = 1) in vec2 texture_coord;
layout(location = 2) in vec4 color;

layout(location = 0) uniform vec4 to_clip;  // scale of x and y, offset of x and y

out vec2 passed_texture_coord;
out vec4 passed_color;

void main() {
  passed_texture_coord = texture_coord;
  passed_color = color;
  gl_Position = vec4(position * to_clip.xy + to_clip.zw, 0.0, 1.0);
}
