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

/// The bits of one bone alone.
std::array<std::uint32_t, general_components> bone_bits(const Packet& packet, int bone);

glm::dquat rotation_of(const Packet& packet, int bone);
glm::dvec3 position_of(const Packet& packet, int bone);
glm::dvec3 scale_of(const Packet& packet, int bone);
void set_rotation(Packet& packet, int bone, const glm::dquat& rotation);

/// Any rotations, unit as floats can be; positions and scales from -1 to 1.
Packet random_packet(unsigned seed);

/// The lanes that no bone has: identity everywhere, and zeros that are negative.
Packet identity_packet();

/// The angle of the rotation between two, rad: 0 for q and -q.
double angle_between(const glm::dquat& a, const glm::dquat& b);

/// As rotation vectors, the short way round, and back.
glm::dvec3 rotation_vector(const glm::dquat& q);
glm::dquat rotation_by(const glm::dvec3& rotation_vector);

}  // namespace throng::anim
