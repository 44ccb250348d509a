#version 450 core

#include "frame_uniforms.glsl"
#include "lighting.glsl"

in vec3 ground_position;

out vec4 darkening;

void main() {
  vec3 from_eye = ground_position - camera_position.xyz;
  float metres = length(from_eye);
  // A shadow fades as the ground does, so that it is never darker than the haze in front of it.
  float clear = exp2(-metres * 0.014);
  darkening = vec4(mix(vec3(1.0), vec3(0.36, 0.42, 0.55), clear), 1.0);
}
