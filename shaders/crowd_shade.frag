#version 450 core

layout(location = 1) uniform float spread;

in vec2 deviations;

out float people;  // a square metre

void main() { people = exp(-0.5 * dot(deviations, deviations)) / (6.2832 * spread * spread); }
