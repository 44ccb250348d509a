#version 450 core

#include "frame_uniforms.glsl"
#include "instance_record.glsl"
#include "lighting.glsl"

layout(location = 0) uniform float sun_side;

const float contact_radius = 0.42;  // metres, for a person of 1.8 metres
const float streak_length = 1.1;

out vec2 place;  // metres, for a person of 1.8 metres: x across the sun's direction, y away from the sun
out float metres;

void main() {
  InstanceRecord instance = instances[gl_InstanceID];
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  vec2 away = -normalize(to_sun.xz);
  vec2 across = vec2(-away.y, away.x);
  place = vec2(mix(-contact_radius, contact_radius, corner.x),
               mix(-contact_radius, contact_radius + streak_length * sun_side, corner.y));
  float scale = instance.scale * instance.contact_scale;
  vec2 ground = position_of(instance).xz + scale * (across * place.x + away * place.y);
  vec3 point = vec3(ground.x, 0.0, ground.y);
  metres = distance(point, camera_position.xyz);
  gl_Position = view_projection * vec4(point, 1.0);
}
