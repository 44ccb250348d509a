#include "engine/anim/bake/rounding.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include "engine/anim/base/pose.h"

namespace throng::anim {

namespace {

/// Axes that are flatter than this have no inverse that is worth taking.
constexpr double least_volume = 1e-9;

/// The rotations of one row, which are rounded bone after bone.
class RoundedRow {
 public:
  RoundedRow(const Skeleton& skeleton, const SampledRows& rows, SampledStream& stream, int row)
      : skeleton_(skeleton),
        stream_(stream),
        exact_(
            std::span(rows.rows).subspan(static_cast<std::size_t>(row) * rows.floats_in_row(), rows.floats_in_row())),
        row_(reinterpret_cast<std::byte*>(&stream) + stream.rows_offset +
             static_cast<std::size_t>(row) * stream.row_stride),
        exact_axes_(skeleton.bones.size()),
        rounded_axes_(skeleton.bones.size()) {}

  void round_all() {
    for (int bone = 0; bone < skeleton_.bone_count(); ++bone) round(bone);
  }

 private:
  void round(int bone) {
    const auto index = static_cast<std::size_t>(bone);
    const Bone& own = skeleton_.bones[index];
    const bool is_root = own.parent < 0;
    const auto parent = static_cast<std::size_t>(std::max(own.parent, 0));
    const glm::dmat3 prefix = skeleton_.rigid ? glm::dmat3(1.0) : glm::dmat3(own.prefix);
    const glm::dmat3 exact_parent = (is_root ? glm::dmat3(1.0) : exact_axes_[parent]) * prefix;
    const glm::dmat3 rounded_parent = (is_root ? glm::dmat3(1.0) : rounded_axes_[parent]) * prefix;
    const glm::dquat rotation = exact_rotation(bone);
    const glm::dmat3 turned = exact_parent * glm::mat3_cast(rotation);
    if (moves(bone) && std::abs(glm::determinant(rounded_parent)) > least_volume) {
      store(bone, glm::normalize(glm::quat_cast(glm::inverse(rounded_parent) * turned)));
    }
    const glm::dvec3 scale = exact_scale(bone);
    exact_axes_[index] = scaled(turned, scale);
    rounded_axes_[index] = scaled(rounded_parent * glm::mat3_cast(stored(bone)), scale);
  }

  static glm::dmat3 scaled(const glm::dmat3& axes, const glm::dvec3& scale) {
    return {axes[0] * scale.x, axes[1] * scale.y, axes[2] * scale.z};
  }

  double exact(int bone, int component) const {
    const int plane = bone / packet_bones * stream_.components + component;
    return static_cast<double>(exact_[static_cast<std::size_t>(plane * packet_bones + bone % packet_bones)]);
  }
  glm::dquat exact_rotation(int bone) const {
    return glm::normalize(glm::dquat(exact(bone, 3), exact(bone, 0), exact(bone, 1), exact(bone, 2)));
  }
  glm::dvec3 exact_scale(int bone) const {
    if (skeleton_.rigid) return glm::dvec3(1.0);
    return {exact(bone, rigid_components), exact(bone, rigid_components + 1), exact(bone, rigid_components + 2)};
  }

  const SampledPacket& packet(int bone) const { return stream_.packets()[bone / packet_bones]; }
  bool moves(int bone) const { return packet(bone).rotation_offset >= 0; }
  std::int16_t& lane(int bone, int component) const {
    auto* const lanes = reinterpret_cast<std::int16_t*>(row_ + packet(bone).rotation_offset);
    return lanes[rotation_lane(packet(bone).lanes, component, bone % packet_bones)];
  }
  double constant(int bone, int axis) const {
    const auto& rotations = packet(bone).at<PacketRotations>(packet(bone).rotation_constants);
    return static_cast<double>(rotations.lanes[axis][bone % packet_bones]);
  }
  glm::dquat stored(int bone) const {
    double q[4];
    for (int axis = 0; axis < 4; ++axis) {
      q[axis] = moves(bone) ? static_cast<double>(lane(bone, axis)) : constant(bone, axis);
    }
    return glm::normalize(glm::dquat(q[3], q[0], q[1], q[2]));
  }
  /// Keeps the hemisphere that the row has.
  void store(int bone, const glm::dquat& rotation) const {
    constexpr auto one = static_cast<double>(quantised_one);
    const double unit = glm::dot(rotation, stored(bone)) < 0.0 ? -one : one;
    const double components[] = {rotation.x, rotation.y, rotation.z, rotation.w};
    for (int axis = 0; axis < 4; ++axis)
      lane(bone, axis) = static_cast<std::int16_t>(std::round(components[axis] * unit));
  }

  const Skeleton& skeleton_;
  SampledStream& stream_;
  std::span<const float> exact_;
  std::byte* row_;
  std::vector<glm::dmat3> exact_axes_, rounded_axes_;
};

}  // namespace

void carry_rounding(const Skeleton& skeleton, const SampledRows& rows, SampledStream& stream) {
  assert(rows.row_count == stream.row_count && rows.bone_count == stream.bone_count);
  for (int row = 0; row < stream.row_count; ++row) RoundedRow(skeleton, rows, stream, row).round_all();
}

}  // namespace throng::anim
