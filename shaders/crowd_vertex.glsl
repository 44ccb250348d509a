// What every program that draws the crowd's surface is given.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 texture_coord;
layout(location = 3) in vec4 color;
layout(location = 4) in vec4 weights;
layout(location = 5) in uint region;
layout(location = 6) in uvec4 palette_entries;

layout(location = 0) uniform uint first_instance;

SkinnedVertex skinned(const InstanceRecord instance) {
  return skin_vertex(instance, now, position, normal, palette_entries, weights);
}
