#version 450 core

layout(binding = 0) uniform sampler2D atlas;

in vec2 passed_texture_coord;
in vec4 passed_color;

out vec4 color;

void main() { color = passed_color * texture(atlas, passed_texture_coord); }
