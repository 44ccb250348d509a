#version 450 core

// Both pictures are read unconverted, because sRGB values differ by about as much as the eye sees.
layout(binding = 0) uniform sampler2D left_picture;
layout(binding = 1) uniform sampler2D right_picture;

layout(location = 0) uniform float divider;  // pixels from the left
layout(location = 1) uniform float amplification;  // of the difference; 0: the right picture itself

const float half_line = 1.0;  // pixels

out vec4 color;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 left = texelFetch(left_picture, pixel, 0).rgb;
  vec3 right = texelFetch(right_picture, pixel, 0).rgb;
  vec3 beyond = amplification > 0.0 ? abs(left - right) * amplification : right;
  float from_divider = gl_FragCoord.x - divider;
  vec3 side = from_divider < 0.0 ? left : beyond;
  color = vec4(abs(from_divider) < half_line ? vec3(1.0) : side, 1.0);
}
