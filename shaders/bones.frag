#version 450 core

in vec3 world_position;
in vec4 debug_color;

out vec4 color;

void main() { color = vec4(mix(vec3(0.95, 0.62, 0.16), debug_color.rgb, debug_color.a), 1.0); }
