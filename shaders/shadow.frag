#version 450 core

#include "frame_uniforms.glsl"
#include "shadow_darkening.glsl"

out vec4 darkening;

void main() { darkening = shadow_darkening(); }
