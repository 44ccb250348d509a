// Computes how a shadow darkens the ground. Include frame_uniforms.glsl before it.
in vec3 ground_position;

vec4 shadow_darkening() {
  vec3 from_eye = ground_position - camera_position.xyz;
  float metres = length(from_eye);
  // A shadow fades as the ground does, so that it is never darker than the haze in front of it.
  float clear = exp2(-metres * 0.014);
  return vec4(mix(vec3(1.0), vec3(0.36, 0.42, 0.55), clear), 1.0);
}
