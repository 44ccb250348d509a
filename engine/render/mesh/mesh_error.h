#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "throng/render/mesh_error_value.h"

#include "engine/render/mesh/cell_tree.h"
#include "engine/render/mesh/surface_paint.h"
#include "engine/render/mesh/surface_simplifier.h"

namespace throng::render {

/// Measures how far the picture of a coarser mesh is from the picture of the full one, in metres.
///
/// Each sample of one surface is paired with the point of the other that is the closest in all poses at once. This is
/// done both ways, so that neither a lost spike nor a new one is missed. The distance of a pair is measured in all
/// poses.
///
/// Where the colours of a pair differ, an edge of colour has moved or a feature is lost. The distance counts as twice
/// the way to the nearest edge: to the sample's colour on the other surface, or to the other colour on the sample's own
/// surface. So a seam has the error by which it moved, and a lost eye an error of about half of its width.
///
/// The error of a pose is the largest distance that as much of the surface exceeds as a square of that width covers.
/// Smaller patches would not show. Surfaces that are hidden in the first pose do not count: the skin under clothes, the
/// inside of a mouth.
///
/// Errors beyond an eighth of the surface's extent count as an eighth. Errors below a five-hundredth, which the samples
/// do not resolve, count as that.
class MeshErrorMeter {
 public:
  /// All parameters outlive the meter. Without `paint` the whole surface has one colour. Pairs are found in the first
  /// of `poses`; without poses, on the surface as it is modelled.
  MeshErrorMeter(const SkinnedSurfaceView& surface, const SurfacePaint* paint, const PosedPalettes& poses);

  /// Returns the errors of a coarser mesh over the same vertices. 99% of the poses have no larger ones.
  MeshError error_of(std::span<const std::uint32_t> indices) const;
  /// Returns the longest side of a box around the full surface in the first pose, in metres.
  float extent() const { return extent_; }
  /// Returns the error that stands for all larger ones.
  float largest_error() const;

 private:
  enum class Seen : std::uint8_t { unknown, yes, no };
  /// A surface that can be searched.
  struct Side {
    std::span<const std::uint32_t> indices;
    CellTree tree{{}};
    std::vector<PointLook> looks;               // [cell], of its middle
    std::unique_ptr<std::atomic<Seen>[]> seen;  // [cell], as found so far by any thread
  };
  struct Sample {
    const SurfaceCell* cell;
    glm::vec3 weights;  // of the cell's corners
    SurfacePoint point;
    PointLook look;
    float area = 0.0F;               // square metres of the surface that it stands for
    std::optional<float> seen_area;  // square metres, where known already
  };
  struct Pair {
    SurfacePoint here, there;
    float recolored = 0.0F;  // metres that an edge of colour has moved
    float seen_area = 0.0F;  // square metres
    bool on_face = false;
  };

  Side side_of(std::span<const std::uint32_t> indices) const;
  std::vector<Sample> samples_of(const Side& side) const;
  Sample sample_at(const Side& side, const SurfaceCell& cell, const glm::vec3& weights) const;
  float seen_area(const Side& side, const Sample& sample) const;
  bool is_seen(const Side& side, const SurfaceCell& cell) const;
  bool is_seen_from(const glm::vec3& direction, const Side& side, const SurfaceCell& cell, const glm::vec3& weights,
                    bool double_sided) const;
  void pair(const Sample& sample, const Side& own, const Side& other, std::vector<Pair>& pairs) const;
  float recolored_by(const Sample& sample, const PointLook& look, const Side& own, const Side& other) const;
  float largest_distance(const SurfacePoint& a, const SurfacePoint& b, float below) const;
  float distance_to_alike(const SurfacePoint& point, const PointLook& look, const Side& side, float limit) const;
  float usual_error(std::span<const Pair> pairs) const;
  float error_in_pose(std::span<const Pair> pairs, std::size_t pose) const;
  bool is_on_face(const SurfacePoint& point) const;

  SurfacePoint point_of(const Side& side, const SurfaceCell& cell, const glm::vec3& weights) const;
  PointLook look_of(const SurfacePoint& point) const;
  glm::vec3 skinned(std::uint32_t vertex, std::span<const glm::mat4x3> palette) const;
  glm::vec3 position_of(const SurfacePoint& point, std::size_t pose) const;

  SkinnedSurfaceView surface_;
  const SurfacePaint* paint_;
  std::vector<std::vector<glm::vec3>> positions_;  // [pose][vertex]
  float extent_ = 0.0F;
  float least_error_ = 0.0F;
  Side full_;
  std::vector<Sample> samples_;  // of full_
};

}  // namespace throng::render
