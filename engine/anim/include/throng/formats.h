#pragma once

namespace throng {

/// The form in which an entry of a palette is written.
enum class PaletteFormat : unsigned char {
  matrices,  ///< the top three rows of an affine matrix, row-major: 48 bytes
  packed     ///< a rotation and a place: 16 bytes, unpacked by packed_palette.glsl; characters that scale get matrices
};

/// The form in which a joint is written. Each begins at a multiple of 16 bytes.
enum class JointFormat : unsigned char {
  transforms,   ///< 8 floats: a rotation, a place and a scale; characters that scale have none
  matrices,     ///< 12 floats: the top three rows of a matrix, row-major
  matrices_4x4  ///< 16 floats, column-major
};

}  // namespace throng
