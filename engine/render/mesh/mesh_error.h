#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/mesh/cell_tree.h"
#include "engine/render/mesh/surface_paint.h"
#include "engine/render/mesh/surface_simplifier.h"

namespace throng::render {

/// Measures how far the picture of a coarser mesh is from that of the full one, in metres.
///
/// Each sample of one surface is paired with the point of the other that is the closest in all poses at once. This is
/// done both ways, so that neither a lost spike nor a new one is missed. The distance of a pair is measured in all
/// poses.
///
/// What cannot be seen in the first pose has no error: the skin under clothes, the inside of a mouth.
///
/// Where the colours of a pair differ, an edge of colour has moved or a feature is lost. The edge has moved as far as
/// the nearest point of the other surface that has the sample's colour, or as the nearest point of the sample's own
/// surface that has the other colour, whichever is nearer. So a seam that moves and a lost eye have errors too.
///
/// Errors beyond a tenth of the surface's extent count as a tenth.
class MeshErrorMeter {
 public:
  /// All parameters outlive the meter. Without `paint` the whole surface has one colour. Pairs are found in the first
  /// of `poses`; without poses, on the surface as it is modelled.
  MeshErrorMeter(const SkinnedSurfaceView& surface, const SurfacePaint* paint, const PosedPalettes& poses);

  /// Returns the error of a mesh over the same vertices: the farthest pair of each pose, of 99% of the poses.
  float error_of(std::span<const std::uint32_t> indices) const;

 private:
  /// A surface that can be searched.
  struct Side {
    std::span<const std::uint32_t> indices;
    CellTree tree{{}};
    std::vector<PointLook> looks;  // [cell], of its middle
  };
  struct Sample {
    SurfacePoint point;
    PointLook look;
  };
  struct Pair {
    SurfacePoint here, there;
  };
  struct Pairs {
    std::vector<Pair> pairs;
    float recolored = 0.0F;  // metres, the farthest that an edge of colour has moved
  };

  Side side_of(std::span<const std::uint32_t> indices) const;
  std::vector<Sample> samples_of(const Side& side) const;
  Sample sample_at(const Side& side, const SurfaceCell& cell, const glm::vec3& weights) const;
  bool is_seen(const Side& side, const SurfaceCell& cell, const glm::vec3& weights) const;
  void pair(const Sample& sample, const Side& own, const Side& other, Pairs& pairs) const;
  float distance_to_alike(const SurfacePoint& point, const PointLook& look, const Side& side, float limit) const;
  float farthest(std::span<const Pair> pairs, std::size_t pose) const;

  SurfacePoint point_of(const Side& side, const SurfaceCell& cell, const glm::vec3& weights) const;
  PointLook look_of(const SurfacePoint& point) const;
  glm::vec3 skinned(std::uint32_t vertex, std::span<const glm::mat4x3> palette) const;
  glm::vec3 position_of(const SurfacePoint& point, std::size_t pose) const;

  SkinnedSurfaceView surface_;
  const SurfacePaint* paint_;
  std::vector<std::vector<glm::vec3>> positions_;  // [pose][vertex]
  float extent_ = 0.0F;                            // of the full surface in the first pose
  Side full_;
  std::vector<Sample> samples_;  // of full_
};

}  // namespace throng::render
