// Skins a vertex by the two palette slots of an instance. Include instance_record.glsl before it.

// An entry has three rows of 3x4 floats; in a packed slot it has one row, which
// engine/anim/kernel/palette/packed_palette.h draws.
layout(std430, binding = 1) readonly buffer PalettePage { uvec4 palette_rows[]; };
// Unpacks an entry: xyz is where its joint rests, w is the length in metres of one unit of its position.
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

struct Rows {
  vec4 x, y, z;
};

void add(inout Rows sum, float weight, const Rows rows) {
  sum.x += weight * rows.x;
  sum.y += weight * rows.y;
  sum.z += weight * rows.z;
}

// The rotation of a bone from its bind pose, not unit, and the place of its joint.
struct JointMotion {
  vec4 rotation;
  vec3 place;
};

bool is_packed(uint slot) { return (slot & packed_slot) != 0u; }

JointMotion unpacked(uint slot, uint entry) {
  uvec4 words = palette_rows[(slot & ~packed_slot) * rows_of_line + entry];
  ivec4 rotation = ivec4(words.x << 16, words.x, words.y << 16, words.y) >> 16;
  ivec3 place = ivec3(words.z << 11, ((words.z >> 21) | (words.w << 11)) << 11, words.w) >> ivec3(11, 11, 10);
  return JointMotion(vec4(rotation), packing_frames[entry].w * vec3(place));
}

// Blends rotations the shorter way round, and places along a straight line.
JointMotion between(const JointMotion from, const JointMotion to, float blend) {
  float side = dot(from.rotation, to.rotation) < 0.0 ? -blend : blend;
  return JointMotion((1.0 - blend) * from.rotation + side * to.rotation, mix(from.place, to.place, blend));
}

Rows rows_of(const JointMotion motion, vec3 pivot) {
  vec4 q = motion.rotation;
  vec3 twice = q.xyz * (2.0 / dot(q, q));
  vec3 squares = q.xyz * twice;
  vec3 products = q.xxy * twice.yzz;  // xy, xz, yz
  vec3 spin = q.w * twice;
  vec3 x = vec3(1.0 - squares.y - squares.z, products.x - spin.z, products.y + spin.y);
  vec3 y = vec3(products.x + spin.z, 1.0 - squares.x - squares.z, products.z - spin.x);
  vec3 z = vec3(products.y - spin.y, products.z + spin.x, 1.0 - squares.x - squares.y);
  vec3 translation = motion.place - vec3(dot(x, pivot), dot(y, pivot), dot(z, pivot));
  return Rows(vec4(x, translation.x), vec4(y, translation.y), vec4(z, translation.z));
}

Rows entry_rows(uint slot, uint entry) {
  if (is_packed(slot)) return rows_of(unpacked(slot, entry), packing_frames[entry].xyz);
  uint row = slot * rows_of_line + 3u * entry;
  return Rows(uintBitsToFloat(palette_rows[row]), uintBitsToFloat(palette_rows[row + 1u]),
              uintBitsToFloat(palette_rows[row + 2u]));
}

Rows entry_rows_between(uint from, uint to, float blend, uint entry) {
  if (is_packed(from) && is_packed(to)) {
    JointMotion motion = between(unpacked(from, entry), unpacked(to, entry), blend);
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
