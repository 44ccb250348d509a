#version 450 core

#include "frame_uniforms.glsl"
#if defined(SHADOWS) || defined(LAMPS)
#include "scenery_light.glsl"

out vec4 color;

void main() { color = seen_from_camera(scattered(facing_normal())); }
#else
// Only the sun and the sky light it, which changes little over a triangle.
in vec3 seen_from_front;
in vec3 seen_from_behind;

out vec4 color;

void main() { color = vec4(gl_FrontFacing ? seen_from_front : seen_from_behind, 1.0); }
#endif
