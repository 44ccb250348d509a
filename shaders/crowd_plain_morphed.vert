#version 450 core
#extension GL_ARB_shader_draw_parameters : require

#include "instance_record.glsl"
#include "morphs.glsl"
#include "crowd_plain_main.glsl"
