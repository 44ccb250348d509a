#version 450 core

out vec4 color;

#ifdef LIT_AT_VERTICES
in vec3 seen_from_front;
in vec3 seen_from_behind;

void main() { color = vec4(gl_FrontFacing ? seen_from_front : seen_from_behind, 1.0); }
#else
#include "frame_uniforms.glsl"
#include "scenery_light.glsl"

void main() { color = seen_from_camera(scattered(facing_normal())); }
#endif
