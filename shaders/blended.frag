#version 450 core

#include "blended_average.glsl"

layout(binding = 0) uniform sampler2D sums;
layout(binding = 1) uniform sampler2D behind;

out vec4 color;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  color = blended_average(texelFetch(sums, pixel, 0), texelFetch(behind, pixel, 0).r);
}
