#version 450 core

#include "frame_uniforms.glsl"
#include "lighting.glsl"
#include "pixel_ray.glsl"

out vec4 color;

void main() { color = vec4(exposed(sky_color(normalize(ray_of_pixel()))), 1.0); }
