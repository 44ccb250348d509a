// Skins a vertex by the two palette slots of an instance. Include instance_record.glsl before it.
#include "palette/packed_palette.glsl"

// An entry has three rows of 3x4 floats; in a packed slot it has one row.
layout(std430, binding = 1) readonly buffer PalettePage { uvec4 palette_rows[]; };
layout(std430, binding = 3) readonly buffer PackingFrames { vec4 packing_frames[]; };

const uint packed_slot = 0x80000000u;
const uint rows_of_line = 4u;

struct SkinnedVertex {
  vec3 position;  // model space
  vec3 normal;    // model space, not unit; so is the tangent
  vec3 tangent;
};

// Gives how far the blend has come: 0 shows `from`, 1 shows `to`.
float blend_of(const InstanceRecord instance, uint now) {
  uint elapsed = now - instance.blend_start;
  if (elapsed >= instance.blend_duration) return 1.0;
  return float(elapsed) / float(instance.blend_duration);
}

void add(inout Rows sum, float weight, const Rows rows) {
  sum.x += weight * rows.x;
  sum.y += weight * rows.y;
  sum.z += weight * rows.z;
}

bool is_packed(uint slot) { return (slot & packed_slot) != 0u; }

JointMotion motion_of(uint slot, uint entry) {
  return unpacked(palette_rows[(slot & ~packed_slot) * rows_of_line + entry], packing_frames[entry]);
}

Rows entry_rows(uint slot, uint entry) {
  if (is_packed(slot)) return rows_of(motion_of(slot, entry), packing_frames[entry].xyz);
  uint row = slot * rows_of_line + 3u * entry;
  return Rows(uintBitsToFloat(palette_rows[row]), uintBitsToFloat(palette_rows[row + 1u]),
              uintBitsToFloat(palette_rows[row + 2u]));
}

Rows entry_rows_between(uint from, uint to, float blend, uint entry) {
  if (is_packed(from) && is_packed(to)) {
    JointMotion motion = between(motion_of(from, entry), motion_of(to, entry), blend);
    return rows_of(motion, packing_frames[entry].xyz);
  }
  Rows a = entry_rows(from, entry), b = entry_rows(to, entry);
  return Rows(mix(a.x, b.x, blend), mix(a.y, b.y, blend), mix(a.z, b.z, blend));
}

vec3 turned_by(const Rows rows, vec3 v) { return vec3(dot(rows.x.xyz, v), dot(rows.y.xyz, v), dot(rows.z.xyz, v)); }

SkinnedVertex skin_vertex(const InstanceRecord instance, uint now, vec3 position, vec3 normal, vec3 tangent,
                          uvec4 entries, vec4 weights) {
  float blend = blend_of(instance, now);
  uint from = instance.palette_from, to = instance.palette_to;
  uint shown = blend > 0.0 ? to : from;
  bool blends = blend > 0.0 && blend < 1.0 && from != to;
  Rows rows = Rows(vec4(0.0), vec4(0.0), vec4(0.0));
  for (int i = 0; i < 4; ++i) {
    add(rows, weights[i],
        blends ? entry_rows_between(from, to, blend, entries[i]) : entry_rows(shown, entries[i]));
  }
  vec4 point = vec4(position, 1.0);
  return SkinnedVertex(vec3(dot(rows.x, point), dot(rows.y, point), dot(rows.z, point)),
                       turned_by(rows, normal), turned_by(rows, tangent));
}
