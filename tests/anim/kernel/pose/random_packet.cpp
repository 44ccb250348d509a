#include "tests/anim/kernel/pose/random_packet.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

namespace throng::anim {

PacketBits bits(const Packet& packet) { return std::bit_cast<PacketBits>(packet); }

std::array<std::uint32_t, general_components> bone_bits(const Packet& packet, int bone) {
  std::array<std::uint32_t, general_components> bits{};
  for (std::size_t component = 0; component < bits.size(); ++component) {
    bits[component] = std::bit_cast<std::uint32_t>(packet.lanes[component][bone]);
  }
  return bits;
}

glm::dquat rotation_of(const Packet& packet, int bone) {
  const auto& q = packet.lanes;
  return {q[3][bone], q[0][bone], q[1][bone], q[2][bone]};
}

glm::dvec3 position_of(const Packet& packet, int bone) {
  return {packet.lanes[4][bone], packet.lanes[5][bone], packet.lanes[6][bone]};
}

glm::dvec3 scale_of(const Packet& packet, int bone) {
  return {packet.lanes[7][bone], packet.lanes[8][bone], packet.lanes[9][bone]};
}

void set_rotation(Packet& packet, int bone, const glm::dquat& rotation) {
  packet.lanes[0][bone] = static_cast<float>(rotation.x);
  packet.lanes[1][bone] = static_cast<float>(rotation.y);
  packet.lanes[2][bone] = static_cast<float>(rotation.z);
  packet.lanes[3][bone] = static_cast<float>(rotation.w);
}

Packet random_packet(unsigned seed) {
  std::mt19937 random(seed);
  const auto signed_unit = [&] { return static_cast<float>(random()) / 2147483648.0F - 1.0F; };
  Packet packet;
  for (auto& component : packet.lanes) {
    for (float& value : component) value = signed_unit();
  }
  for (int bone = 0; bone < packet_bones; ++bone) set_rotation(packet, bone, glm::normalize(rotation_of(packet, bone)));
  return packet;
}

Packet identity_packet() {
  Packet packet;
  for (auto& component : packet.lanes) std::fill(std::begin(component), std::end(component), -0.0F);
  for (const int component : {3, 7, 8, 9}) {
    std::fill(std::begin(packet.lanes[component]), std::end(packet.lanes[component]), 1.0F);
  }
  return packet;
}

double angle_between(const glm::dquat& a, const glm::dquat& b) {
  return glm::length(rotation_vector(b * glm::conjugate(a)));
}

glm::dvec3 rotation_vector(const glm::dquat& q) {
  const glm::dvec3 axis(q.x, q.y, q.z);
  const double sine = glm::length(axis);
  if (sine < 1e-12) return glm::dvec3(0.0);
  return axis * ((q.w < 0.0 ? -2.0 : 2.0) * std::atan2(sine, std::abs(q.w)) / sine);
}

glm::dquat rotation_by(const glm::dvec3& rotation_vector) {
  const double angle = glm::length(rotation_vector);
  if (angle < 1e-12) return {1.0, 0.0, 0.0, 0.0};
  const glm::dvec3 axis = rotation_vector * (std::sin(angle / 2.0) / angle);
  return {std::cos(angle / 2.0), axis.x, axis.y, axis.z};
}

}  // namespace throng::anim
