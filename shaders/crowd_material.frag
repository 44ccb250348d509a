#version 450 core

#include "frame_uniforms.glsl"
#include "lighting.glsl"
#include "shadows.glsl"
#include "lamps.glsl"
#include "crowd_surface.glsl"
#include "crowd_shading.glsl"
#include "crowd_material.glsl"
#include "crowd_emission.glsl"

out vec4 color;

void main() { color = vec4(glowing(surface_color().rgb), 1.0); }
