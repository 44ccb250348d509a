// Lets a program draw the instances of a list. Include instance_record.glsl before it, and it before crowd_vertex.glsl.
#define OF_A_LIST

layout(std430, binding = 8) readonly buffer Casters { uint casters[]; };
