#version 450 core

#include "frame_uniforms.glsl"
#include "scenery_light.glsl"

out vec4 color;

void main() { color = seen_from_camera(scattered(facing_normal())); }
