#version 450 core

#include "color.glsl"

layout(location = 1) uniform float opacity;

in vec4 passed_color;
in float pixels_from_middle;

out vec4 color;

void main() {
  float edge = clamp(1.75 - abs(pixels_from_middle), 0.0, 1.0);
  color = vec4(to_linear(passed_color.rgb), passed_color.a * opacity * edge);
}
