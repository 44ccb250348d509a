#version 450 core

#include "frame_uniforms.glsl"
#include "scenery_instance.glsl"

layout(location = 0) uniform mat4 depth_matrix;

void main() { gl_Position = depth_matrix * vec4(placed(scenery[instance]), 1.0); }
