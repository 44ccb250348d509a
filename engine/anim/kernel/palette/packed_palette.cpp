#include "engine/anim/kernel/palette/packed_palette.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

namespace throng::anim {
namespace {

struct Unpacked {
  glm::quat rotation;  // not unit
  glm::vec3 joint;     // metres
};

float low_half(std::uint32_t word) { return static_cast<float>(static_cast<std::int16_t>(word & 0xFFFFU)); }
float high_half(std::uint32_t word) { return static_cast<float>(static_cast<std::int16_t>(word >> 16U)); }

/// Returns the lowest 21 bits as a signed number.
float signed_joint_bits(std::uint32_t bits) {
  constexpr unsigned unused = 32U - packed_joint_bits;
  return static_cast<float>(static_cast<std::int32_t>(bits << unused) >> unused);
}

Unpacked unpacked(const PackedPaletteEntry& entry, float step) {
  const auto& words = entry.words;
  return {glm::quat(high_half(words[1]), low_half(words[0]), high_half(words[0]), low_half(words[1])),
          step * glm::vec3(signed_joint_bits(words[2]), signed_joint_bits((words[2] >> 21U) | (words[3] << 11U)),
                           signed_joint_bits(words[3] >> 10U))};
}

PaletteMatrix matrix_of(const Unpacked& motion, const PackingFrame& frame) {
  const glm::mat3 turn = glm::mat3_cast(glm::normalize(motion.rotation));
  const glm::vec3 translation = motion.joint - turn * glm::vec3(frame.pivot[0], frame.pivot[1], frame.pivot[2]);
  PaletteMatrix matrix{};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) matrix.rows[row][column] = turn[column][row];
    matrix.rows[row][3] = translation[row];
  }
  return matrix;
}

}  // namespace

PaletteMatrix unpack(const PackedPaletteEntry& entry, const PackingFrame& frame) {
  return matrix_of(unpacked(entry, frame.step), frame);
}

PaletteMatrix unpack_between(const PackedPaletteEntry& from, const PackedPaletteEntry& to, const PackingFrame& frame,
                             float blend) {
  const Unpacked a = unpacked(from, frame.step);
  const Unpacked b = unpacked(to, frame.step);
  const float side = glm::dot(a.rotation, b.rotation) < 0.0F ? -1.0F : 1.0F;
  return matrix_of({a.rotation * (1.0F - blend) + b.rotation * (side * blend), glm::mix(a.joint, b.joint, blend)},
                   frame);
}

}  // namespace throng::anim
