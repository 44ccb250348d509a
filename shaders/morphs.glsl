// Adds the morphs of an instance to a vertex in the bind pose, in programs with the switch MORPHED. Include
// instance_record.glsl before it, and it before crowd_vertex.glsl, which calls it.

// Repeats the layout of engine/render/mesh/morph_table.h.
struct MorphEntry {
  uint morph;
  float position_x, position_y, position_z;
  float normal_x, normal_y, normal_z;
};
layout(std430, binding = 4) readonly buffer MorphFirsts { uint morph_firsts[]; };  // one more than vertices
layout(std430, binding = 5) readonly buffer MorphEntries { MorphEntry morph_entries[]; };
layout(std430, binding = 6) readonly buffer MorphWeights { float morph_weights[]; };

void add_morphs(const InstanceRecord instance, uint vertex, inout vec3 position, inout vec3 normal) {
  if (instance.weights == 0u) return;
  uint first = instance.weights - 1u;
  for (uint i = morph_firsts[vertex]; i < morph_firsts[vertex + 1u]; ++i) {
    MorphEntry entry = morph_entries[i];
    float weight = morph_weights[first + entry.morph];
    position += weight * vec3(entry.position_x, entry.position_y, entry.position_z);
    normal += weight * vec3(entry.normal_x, entry.normal_y, entry.normal_z);
  }
}
