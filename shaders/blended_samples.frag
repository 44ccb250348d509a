#version 450 core

#include "blended_average.glsl"

layout(binding = 0) uniform sampler2DMS sums;
layout(binding = 1) uniform sampler2DMS behind;

out vec4 color;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  color = blended_average(texelFetch(sums, pixel, gl_SampleID), texelFetch(behind, pixel, gl_SampleID).r);
}
