// Declares the inputs of every program that draws the crowd's surface.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 texture_coord;
layout(location = 3) in vec4 color;
layout(location = 4) in vec4 weights;
layout(location = 5) in vec3 shape;
layout(location = 6) in vec2 hair;
layout(location = 7) in uint region;
layout(location = 8) in vec2 emission_coord;
layout(location = 9) in vec2 metallic_roughness_coord;
layout(location = 10) in vec2 normal_coord;
layout(location = 11) in vec2 occlusion_coord;
layout(location = 12) in vec4 tangent;  // w: the side of the bitangent
layout(location = 13) in float trim;
layout(location = 14) in vec4 face;

layout(location = 0) uniform uint vertex_count;

// Four 16-bit entries a vertex, [bone level][vertex]. A bone that a level drops follows its nearest kept ancestor.
layout(std430, binding = 2) readonly buffer PaletteEntries { uvec2 palette_entries[]; };

uvec4 entries_at(uint bone_level) {
  uvec2 pairs = palette_entries[bone_level * vertex_count + uint(gl_VertexID)];
  return uvec4(pairs.x & 0xFFFFu, pairs.x >> 16, pairs.y & 0xFFFFu, pairs.y >> 16);
}

// The instances of a draw, by their numbers: a list of those who are drawn with a piece, or cast a shadow.
layout(std430, binding = 8) readonly buffer Drawn { uint drawn[]; };

uint drawn_number() { return drawn[gl_BaseInstanceARB + gl_InstanceID]; }
InstanceRecord drawn_instance() { return instances[drawn_number()]; }

SkinnedVertex skinned(const InstanceRecord instance) {
  vec3 own_position = position, own_normal = normal;
#ifdef MORPHED
  add_morphs(instance, uint(gl_VertexID), own_position, own_normal);
#endif
  own_position = varied(instance, own_position, own_normal, shape, hair);
#ifdef DRESSED
  own_position += face_of(instance, own_normal, face);
#endif
  return skin_vertex(instance, now, own_position, own_normal, tangent.xyz, entries_at(instance.bone_level), weights);
}
