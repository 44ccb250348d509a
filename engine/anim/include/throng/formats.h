#pragma once

namespace throng {

/// The form in which an entry of a palette is written.
///
/// A packed entry has 16 bytes, four little-endian words. They say how the bone is turned from its bind pose, and where
/// its joint is:
///
///               bit 31                             bit 0
///     word 0   |   rotation y    |   rotation x    |   16 bits each, signed; a quaternion that is not unit
///     word 1   |   rotation w    |   rotation z    |
///     word 2   | joint y, low 11 |   joint x, 21   |   signed, in units of frame[3] metres
///     word 3   |   joint z, 22   | joint y, high 10|
///
/// `frame` is the entry's of Character::packing_frames(). A vertex p is drawn at
/// rotation * (p - (frame[0], frame[1], frame[2])) + joint, as packed_palette.glsl does it.
enum class PaletteFormat : unsigned char {
  matrices,  ///< the top three rows of an affine matrix, row-major: 48 bytes
  packed     ///< a rotation and a place: 16 bytes; characters that scale get matrices
};

/// The form in which a joint is written. Each begins at a multiple of 16 bytes.
enum class JointFormat : unsigned char {
  transforms,   ///< 8 floats: a rotation, a place and a scale; characters that scale have none
  matrices,     ///< 12 floats: the top three rows of a matrix, row-major
  matrices_4x4  ///< 16 floats, column-major
};

}  // namespace throng
