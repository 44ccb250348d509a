#version 450 core
#extension GL_ARB_shader_draw_parameters : require
// An end of a bone, nearer to the camera than it is, so that its own body does not hide it.

#include "frame_uniforms.glsl"
#include "instance_record.glsl"
#include "skinning.glsl"
#include "variants.glsl"
#include "crowd_vertex.glsl"

layout(location = 1) uniform float reach;  // metres, of an agent of scale 1

const float farthest_share = 0.5;  // of the way to the camera

void main() {
  InstanceRecord instance = instances[gl_BaseInstanceARB + gl_InstanceID];
  vec3 joint = to_world(instance, skinned(instance).position);
  vec3 way = camera_position.xyz - joint;
  float share = min(reach * instance.scale / max(length(way), 1e-6), farthest_share);
  gl_Position = view_projection * vec4(joint + share * way, 1.0);
}
