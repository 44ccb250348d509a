// Unpacks an entry of a packed palette, which is 16 bytes, to the rows of its matrix: PaletteFormat::packed of
// throng/formats.h. It declares no buffer, so a host binds palettes and frames as it likes: an entry is a uvec4 (bits of
// floats may change, bits of integers do not), and its frame is a vec4 of Character::packing_frames().
//
//     Rows rows = rows_of(unpacked(words, frame), frame.xyz);
//     vec3 place = vec3(dot(rows.x, point), dot(rows.y, point), dot(rows.z, point));  // point.w is 1
//
// That header draws the layout.

// The top three rows of an affine matrix.
struct Rows {
  vec4 x, y, z;
};

// The rotation of a bone from its bind pose, not unit, and the place of its joint.
struct JointMotion {
  vec4 rotation;
  vec3 place;
};

// Unpacks an entry: frame.xyz is where its joint rests, frame.w is the length in metres of one unit of its position.
JointMotion unpacked(uvec4 words, vec4 frame) {
  ivec4 rotation = ivec4(words.x << 16, words.x, words.y << 16, words.y) >> 16;
  ivec3 place = ivec3(words.z << 11, ((words.z >> 21) | (words.w << 11)) << 11, words.w) >> ivec3(11, 11, 10);
  return JointMotion(vec4(rotation), frame.w * vec3(place));
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
