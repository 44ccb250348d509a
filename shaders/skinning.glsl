// Skinning by the two palette slots of an instance. Wants instance_record.glsl.

// Three rows of 3x4 an entry.
layout(std430, binding = 1) readonly buffer PalettePage { vec4 palette_rows[]; };

struct SkinnedVertex {
  vec3 position;  // model space
  vec3 normal;    // model space, not unit
};

// 0 shows `from`, 1 shows `to`.
float blend_of(const InstanceRecord instance, uint now) {
  uint elapsed = now - instance.blend_start;
  if (elapsed >= instance.blend_duration) return 1.0;
  return float(elapsed) / float(instance.blend_duration);
}

struct Rows {
  vec4 x, y, z;
};

Rows blended_influences(uint slot, uvec4 entries, vec4 weights) {
  Rows sum = Rows(vec4(0.0), vec4(0.0), vec4(0.0));
  for (int i = 0; i < 4; ++i) {
    uint row = (slot + entries[i]) * 3u;
    sum.x += weights[i] * palette_rows[row];
    sum.y += weights[i] * palette_rows[row + 1u];
    sum.z += weights[i] * palette_rows[row + 2u];
  }
  return sum;
}

SkinnedVertex skin_vertex(const InstanceRecord instance, uint now, vec3 position, vec3 normal, uvec4 entries,
                          vec4 weights) {
  float blend = blend_of(instance, now);
  uint shown = blend > 0.0 ? instance.palette_to : instance.palette_from;
  Rows rows = blended_influences(shown, entries, weights);
  if (blend > 0.0 && blend < 1.0 && instance.palette_from != instance.palette_to) {
    Rows from = blended_influences(instance.palette_from, entries, weights);
    rows.x = mix(from.x, rows.x, blend);
    rows.y = mix(from.y, rows.y, blend);
    rows.z = mix(from.z, rows.z, blend);
  }
  vec4 point = vec4(position, 1.0);
  return SkinnedVertex(vec3(dot(rows.x, point), dot(rows.y, point), dot(rows.z, point)),
                       vec3(dot(rows.x.xyz, normal), dot(rows.y.xyz, normal), dot(rows.z.xyz, normal)));
}
