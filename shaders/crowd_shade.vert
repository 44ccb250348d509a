#version 450 core

// A person in the map of how crowded the ground is: a bell of a whole person.
#include "instance_record.glsl"

layout(location = 0) uniform vec3 map;  // x and z of its corner, 1 / metres of its side
layout(location = 1) uniform float spread;

const float reach = 2.6;  // deviations

out vec2 deviations;

void main() {
  InstanceRecord instance = instances[gl_InstanceID];
  deviations = reach * (2.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1.0);
  // What has no spot below it is in the air, or lies.
  float there = instance.contact_scale > 0.0 ? 1.0 : 0.0;
  vec2 place = position_of(instance).xz + spread * there * deviations;
  gl_Position = vec4(2.0 * (place - map.xy) * map.z - 1.0, 0.0, 1.0);
}
