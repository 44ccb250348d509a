#version 450 core
#extension GL_ARB_shader_draw_parameters : require

// Runs the crowd's own skinning; transform feedback captures the results.
#include "frame_uniforms.glsl"
#include "instance_record.glsl"
#include "morphs.glsl"
#include "skinning.glsl"
#include "variants.glsl"
#include "crowd_vertex.glsl"

out vec3 world_position;
out vec3 world_normal;

void main() {
  InstanceRecord instance = instances[gl_BaseInstanceARB + gl_InstanceID];
  SkinnedVertex vertex = skinned(instance);
  world_position = to_world(instance, vertex.position);
  world_normal = turned(instance, vertex.normal);
}
