#pragma once

#include <cstddef>
#include <cstdint>

namespace throng::anim {

/// Poses are kept in packets of 16 bones, structure of arrays, so that one packet fills the widest vector used:
///
///     pose   = [packet][component][bone 0..15]            float, 64-byte aligned
///     packet = qx[16] qy[16] qz[16] qw[16]  px[16] py[16] pz[16]  ( sx[16] sy[16] sz[16] )
///              '-- rotation, unit to 1e-6-' '--- position, m ---'  '- general path only -'
///
/// On rigid skeletons values are relative to the bind pose (see ReferenceFrame), which is identity and zero. Lanes from
/// the bone count on hold the identity.
inline constexpr int packet_bones = 16;

inline constexpr int widest_strip = 16;  ///< characters that a kernel poses side by side

/// A quad is four bones side by side. Few bones of a rigid skeleton are displaced, so quads say which positions matter.
inline constexpr int quad_bones = 4;
inline constexpr int packet_quads = packet_bones / quad_bones;
using QuadMask = std::uint32_t;  ///< quads of a packet: bit i stands for its bones 4 i to 4 i + 3
inline constexpr QuadMask all_quads = (1U << packet_quads) - 1U;
constexpr bool is_in(QuadMask quads, int quad) { return (quads >> quad & 1U) != 0; }

/// A set of quads of a whole pose has four bits a packet. Packets from 15 on share the last four.
constexpr int first_quad_bit(int packet) { return packet_quads * (packet < 15 ? packet : 15); }
constexpr std::uint64_t quads_with(int bone) {
  return std::uint64_t{1} << (first_quad_bit(bone / packet_bones) + bone % packet_bones / quad_bones);
}
constexpr QuadMask quads_of_packet(std::uint64_t quads, int packet) {
  return static_cast<QuadMask>(quads >> first_quad_bit(packet)) & all_quads;
}

inline constexpr int rigid_components = 7;     // 448 bytes a packet
inline constexpr int general_components = 10;  // 640 bytes a packet

constexpr int packets_for(int bone_count) { return (bone_count + packet_bones - 1) / packet_bones; }
constexpr std::size_t packet_bytes(int components) {
  return static_cast<std::size_t>(components) * packet_bones * sizeof(float);
}
constexpr std::size_t pose_bytes(int bone_count, int components) {
  return static_cast<std::size_t>(packets_for(bone_count)) * packet_bytes(components);
}

static_assert(pose_bytes(62, rigid_components) == 1792, "a held pose of 62 bones: four packets of 448 bytes");

}  // namespace throng::anim
