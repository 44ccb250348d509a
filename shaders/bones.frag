#version 450 core

layout(location = 3) uniform float opacity;

noperspective in float pixels_from_middle;
noperspective in float half_width;

out vec4 color;

const vec3 bone = vec3(0.95, 0.80, 0.48), outline = vec3(0.012, 0.010, 0.008);
const float outline_width = 1.0;  // pixels
const float outline_opacity = 0.75;

void main() {
  float beyond = abs(pixels_from_middle) - half_width;
  float inside = clamp(0.5 - beyond, 0.0, 1.0);
  float covered = max(inside, outline_opacity * clamp(0.5 + outline_width - beyond, 0.0, 1.0));
  color = vec4(mix(outline, bone, inside), covered * opacity);
}
