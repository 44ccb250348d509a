#pragma once

#include <cstddef>
#include <cstdint>

#include "throng/formats.h"

#include "engine/anim/base/transform.h"

namespace throng::anim {

/// One entry of the palette of a rigid skeleton, as PaletteFormat draws it. Rotations are in units of
/// 1 / packed_rotation_one, joints in units of PackingFrame::step.
///
/// It has the place of the joint and not of model space's origin, so that an error of the rotation is seen at the
/// length of a limb and not at the height of a person. Its twin on the device is shaders/palette/packed_palette.glsl.
struct PackedPaletteEntry {
  std::uint32_t words[4];
};
static_assert(sizeof(PackedPaletteEntry) == 16);

/// The number for 1 in a packed rotation. It is a little less than 2^15, because a product along a chain of bones is
/// not quite unit. Length does not matter in unpacking.
inline constexpr float packed_rotation_one = 32700.0F;
inline constexpr int packed_joint_bits = 21;
inline constexpr float packed_joint_limit = static_cast<float>((1 << (packed_joint_bits - 1)) - 1);

/// Data to unpack the entries of a bone, shared by all characters of a skeleton.
struct PackingFrame {
  float pivot[3];  ///< the joint in the bind pose, metres, in the space of the palette
  float step;      ///< metres a unit of the joint's position, a power of two
};
static_assert(sizeof(PackingFrame) == 16, "a vec4 of the device");

/// Returns the matrix of an entry, as the vertex shader computes it.
PaletteMatrix unpack(const PackedPaletteEntry& entry, const PackingFrame& frame);

/// Returns the matrix between two entries: rotations the shortest way and joints straight, by `blend` from 0 (`from`)
/// to 1.
PaletteMatrix unpack_between(const PackedPaletteEntry& from, const PackedPaletteEntry& to, const PackingFrame& frame,
                             float blend);

constexpr std::size_t palette_entry_bytes(PaletteFormat format) {
  return format == PaletteFormat::packed ? sizeof(PackedPaletteEntry) : sizeof(PaletteMatrix);
}

/// Returns the bytes from one palette to the next where many lie in a row: whole cache lines, and an odd number of
/// them. The palettes of a strip are written side by side. If they were an even number of lines apart, several of them
/// would meet in the same few sets of L1 and evict each other.
constexpr std::size_t palette_stride(std::size_t entries, PaletteFormat format) {
  constexpr std::size_t line_bytes = 64;
  return ((entries * palette_entry_bytes(format) + line_bytes - 1) / line_bytes | 1U) * line_bytes;
}

/// The address at which a palette or a list of joints is written, in the format of its skeleton; null: it is not
/// written.
class PaletteDestination {
 public:
  PaletteDestination() = default;
  // Implicit, as pointers convert.
  PaletteDestination(std::byte* memory) : memory_(memory) {}
  PaletteDestination(std::nullptr_t) {}
  PaletteDestination(PaletteMatrix* entries) : memory_(reinterpret_cast<std::byte*>(entries)) {}
  PaletteDestination(PackedPaletteEntry* entries) : memory_(reinterpret_cast<std::byte*>(entries)) {}
  PaletteDestination(JointTransform* joints) : memory_(reinterpret_cast<std::byte*>(joints)) {}
  PaletteDestination(Matrix4x4* joints) : memory_(reinterpret_cast<std::byte*>(joints)) {}

  std::byte* memory() const { return memory_; }
  /// Returns whether it is not at a multiple of 16 bytes, where no palette can be written.
  bool is_misaligned() const { return reinterpret_cast<std::uintptr_t>(memory_) % 16 != 0; }
  friend bool operator==(const PaletteDestination&, const PaletteDestination&) = default;

 private:
  std::byte* memory_ = nullptr;
};
static_assert(sizeof(PaletteDestination) == sizeof(void*));

}  // namespace throng::anim
