#pragma once

#include <array>
#include <cstdint>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "engine/anim/base/pose.h"

namespace throng::anim {

/// Sixteen bones with scale.
struct alignas(64) Packet {
  float lanes[general_components][packet_bones];

  const float* data() const { return lanes[0]; }
  float* data() { return lanes[0]; }
};

using PacketBits = std::array<std::uint32_t, sizeof(Packet) / 4>;
PacketBits bits(const Packet& packet);

/// Returns the bits of one bone alone.
std::array<std::uint32_t, general_components> bone_bits(const Packet& packet, int bone);

glm::dquat rotation_of(const Packet& packet, int bone);
glm::dvec3 position_of(const Packet& packet, int bone);
glm::dvec3 scale_of(const Packet& packet, int bone);
void set_rotation(Packet& packet, int bone, const glm::dquat& rotation);

/// Returns random rotations, as unit as floats can be, and positions and scales from -1 to 1.
Packet random_packet(unsigned seed);

/// Returns the lanes that no bone has: identity everywhere, and zeros that are negative.
Packet identity_packet();

/// Returns the angle of the rotation between two, in radians: 0 for q and -q.
double angle_between(const glm::dquat& a, const glm::dquat& b);

/// Returns a rotation as a rotation vector, the short way round.
glm::dvec3 rotation_vector(const glm::dquat& q);
/// Returns the rotation of a rotation vector.
glm::dquat rotation_by(const glm::dvec3& rotation_vector);

}  // namespace throng::anim
