#version 450 core
#extension GL_ARB_shader_draw_parameters : require

#include "crowd_plain_main.glsl"
