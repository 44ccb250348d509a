#pragma once

/// The numbers of the public headers. They are plain structs, so that a host casts its own vectors to them and needs no
/// other library. Right-handed, +Y up, characters face +Z, metres.
namespace throng {

struct Vec3 {
  float x = 0.0F;
  float y = 0.0F;
  float z = 0.0F;

  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

/// A rotation: a unit quaternion.
struct Quat {
  float x = 0.0F;
  float y = 0.0F;
  float z = 0.0F;
  float w = 1.0F;

  friend constexpr bool operator==(const Quat&, const Quat&) = default;
};

/// A matrix, column by column, as OpenGL has it.
struct Mat4 {
  float columns[4][4] = {{1.0F}, {0.0F, 1.0F}, {0.0F, 0.0F, 1.0F}, {0.0F, 0.0F, 0.0F, 1.0F}};

  friend constexpr bool operator==(const Mat4&, const Mat4&) = default;
};

/// Returns the matrix of 16 numbers, column by column.
inline Mat4 to_mat4(const float* columns) {
  Mat4 matrix;
  for (int i = 0; i < 16; ++i) matrix.columns[i / 4][i % 4] = columns[i];
  return matrix;
}

/// The place of a thing of constant size: it is turned first, then moved.
struct Place {
  Vec3 position{};
  Quat rotation{};

  friend constexpr bool operator==(const Place&, const Place&) = default;
};

/// A ball that holds something.
struct BoundingSphere {
  Vec3 centre{};
  float radius = 0.0F;

  friend constexpr bool operator==(const BoundingSphere&, const BoundingSphere&) = default;
};

/// A box along the axes that holds something.
struct BoundingBox {
  Vec3 low{};
  Vec3 high{};

  friend constexpr bool operator==(const BoundingBox&, const BoundingBox&) = default;
};

/// A local transform as glTF writes it (2.0, 3.5.3): scale first, then rotation, then translation.
struct LocalTransform {
  Vec3 translation{};
  Quat rotation{};
  Vec3 scale{1.0F, 1.0F, 1.0F};
};

}  // namespace throng
