#include "engine/render/mesh/mesh_error.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace throng::render {
namespace {

constexpr float cells_of_extent = 100.0F;   // an edge of colour is found to about a hundredth of a person's height
constexpr float farthest_of_extent = 0.1F;  // farther counterparts are not looked for
constexpr std::size_t most_samples = 2000;  // of corners, and again of cells
constexpr double poses_kept = 0.99;
constexpr glm::vec3 middle(1.0F / 3.0F);  // weights

float extent_of(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
  glm::vec3 low(INFINITY), high(-INFINITY);
  for (const std::uint32_t index : indices) {
    low = glm::min(low, positions[index]);
    high = glm::max(high, positions[index]);
  }
  const glm::vec3 extent = high - low;
  return indices.empty() ? 0.0F : std::max({extent.x, extent.y, extent.z});
}

/// Returns every how many of `count` one is taken, so that at most `most` are.
std::size_t stride_for(std::size_t count, std::size_t most) {
  return std::max<std::size_t>(1, (count + most - 1) / most);
}

}  // namespace

MeshErrorMeter::MeshErrorMeter(const SkinnedSurfaceView& surface, const SurfacePaint* paint, const PosedPalettes& poses)
    : surface_(surface), paint_(paint) {
  positions_.resize(std::max<std::size_t>(poses.size(), 1));
  for (std::size_t pose = 0; pose < positions_.size(); ++pose) {
    const auto palette = poses.empty() ? std::span<const glm::mat4x3>() : std::span(poses[pose]);
    for (std::uint32_t vertex = 0; vertex < surface.influences.size(); ++vertex) {
      positions_[pose].push_back(skinned(vertex, palette));
    }
  }
  extent_ = extent_of(positions_.front(), surface.indices);
  full_ = side_of(surface.indices);
  samples_ = samples_of(full_);
}

float MeshErrorMeter::error_of(std::span<const std::uint32_t> indices) const {
  const Side coarse = side_of(indices);
  Pairs pairs;
  for (const Sample& sample : samples_) pair(sample, full_, coarse, pairs);
  for (const Sample& sample : samples_of(coarse)) pair(sample, coarse, full_, pairs);
  std::vector<float> errors;
  for (std::size_t pose = 0; pose < positions_.size(); ++pose) errors.push_back(farthest(pairs.pairs, pose));
  const auto kept = static_cast<std::ptrdiff_t>(std::ceil(poses_kept * static_cast<double>(errors.size()))) - 1;
  std::nth_element(errors.begin(), errors.begin() + kept, errors.end());
  return std::max(errors[static_cast<std::size_t>(kept)], pairs.recolored);
}

MeshErrorMeter::Side MeshErrorMeter::side_of(std::span<const std::uint32_t> indices) const {
  const float longest_edge = std::max(extent_ / cells_of_extent, 1e-9F);
  Side side{.indices = indices, .tree = CellTree({}), .looks = {}};
  std::vector<SurfaceCell> cells = cut_into_cells(positions_.front(), indices, longest_edge);
  for (SurfaceCell& cell : cells) cell.hides = !look_of(point_of(side, cell, middle)).seen_through;
  side.tree = CellTree(std::move(cells));
  for (const SurfaceCell& cell : side.tree.cells()) side.looks.push_back(look_of(point_of(side, cell, middle)));
  return side;
}

// Corners of triangles are where a surface reaches farthest. The middles of cells are everywhere.
std::vector<MeshErrorMeter::Sample> MeshErrorMeter::samples_of(const Side& side) const {
  std::vector<Sample> samples;
  const std::span cells = side.tree.cells();
  const std::size_t cell_stride = stride_for(cells.size(), most_samples);
  const std::size_t triangle_stride = stride_for(side.indices.size() / 3, most_samples);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i % cell_stride == 0 && is_seen(side, cells[i], middle)) samples.push_back(sample_at(side, cells[i], middle));
    if (cells[i].triangle % triangle_stride != 0) continue;
    for (glm::length_t corner = 0; corner < 3; ++corner) {
      glm::vec3 weights(0.0F);
      weights[corner] = 1.0F;
      const bool is_of_triangle = cells[i].weights.at(static_cast<std::size_t>(corner)) == weights;
      if (is_of_triangle && is_seen(side, cells[i], weights)) samples.push_back(sample_at(side, cells[i], weights));
    }
  }
  std::erase_if(samples, [](const Sample& sample) { return sample.look.cut_out; });
  return samples;
}

MeshErrorMeter::Sample MeshErrorMeter::sample_at(const Side& side, const SurfaceCell& cell,
                                                 const glm::vec3& weights) const {
  // A corner lies on the borders of several colours: a point beside it says whose it is.
  constexpr float beside = 0.8F;
  const glm::vec3 inside = weights * beside + middle * (1.0F - beside);
  return {.point = point_of(side, cell, weights), .look = look_of(point_of(side, cell, inside))};
}

// A point is seen if light comes to it from any of these directions. They are spread evenly over a sphere.
bool MeshErrorMeter::is_seen(const Side& side, const SurfaceCell& cell, const glm::vec3& weights) const {
  constexpr int directions = 26;
  constexpr float golden_angle = 2.39996F;
  const glm::vec3 inside = weights * 0.9F + middle * 0.1F;
  const glm::vec3 at = position_in(cell, inside);
  const glm::vec3 normal = glm::cross(cell.corners[1] - cell.corners[0], cell.corners[2] - cell.corners[0]);
  for (int i = 0; i < directions; ++i) {
    const float y = (2.0F * static_cast<float>(i) + 1.0F) / directions - 1.0F, radius = std::sqrt(1.0F - y * y);
    const float angle = golden_angle * static_cast<float>(i) + 0.1F;
    const glm::vec3 direction(radius * std::cos(angle), y, radius * std::sin(angle));
    const bool is_front = glm::dot(direction, normal) > 0.0F;
    if (!is_front && !side.looks[static_cast<std::size_t>(&cell - side.tree.cells().data())].double_sided) continue;
    if (!side.tree.meets_a_cell(at + direction * (extent_ * 1e-4F), direction)) return true;
  }
  return false;
}

void MeshErrorMeter::pair(const Sample& sample, const Side& own, const Side& other, Pairs& pairs) const {
  const float most = extent_ * farthest_of_extent;
  const auto distance = [&](const SurfaceCell& cell, const glm::vec3& weights, float below) {
    const SurfacePoint there = point_of(other, cell, weights);
    float largest = 0.0F;
    for (std::size_t pose = 0; pose < positions_.size() && largest < below; ++pose) {
      largest = std::max(largest, glm::distance(position_of(there, pose), position_of(sample.point, pose)));
    }
    return largest;
  };
  const auto closest = other.tree.closest(position_of(sample.point, 0), most, distance);
  if (closest.cell == nullptr) {
    pairs.recolored = std::max(pairs.recolored, most);
    return;
  }
  const SurfacePoint there = point_of(other, *closest.cell, closest.weights);
  pairs.pairs.push_back({sample.point, there});
  const PointLook look = look_of(there);
  if (look_alike(look, sample.look)) return;
  const float in_other = distance_to_alike(sample.point, sample.look, other, most);
  if (in_other <= pairs.recolored) return;
  pairs.recolored = std::max(pairs.recolored, distance_to_alike(sample.point, look, own, in_other));
}

float MeshErrorMeter::distance_to_alike(const SurfacePoint& point, const PointLook& look, const Side& side,
                                        float limit) const {
  const glm::vec3 from = position_of(point, 0);
  const std::span cells = side.tree.cells();
  const auto distance = [&](const SurfaceCell& cell, glm::vec3& weights, float /*below*/) {
    if (!look_alike(look_of(point_of(side, cell, weights)), look)) {
      weights = middle;
      if (!look_alike(side.looks[static_cast<std::size_t>(&cell - cells.data())], look)) return INFINITY;
    }
    return glm::distance(position_in(cell, weights), from);
  };
  return side.tree.closest(from, limit, distance).distance;
}

float MeshErrorMeter::farthest(std::span<const Pair> pairs, std::size_t pose) const {
  float distance = 0.0F;
  for (const Pair& pair : pairs) {
    distance = std::max(distance, glm::distance(position_of(pair.here, pose), position_of(pair.there, pose)));
  }
  return distance;
}

SurfacePoint MeshErrorMeter::point_of(const Side& side, const SurfaceCell& cell, const glm::vec3& weights) const {
  SurfacePoint point{
      .vertices = {},
      .weights = cell.weights[0] * weights.x + cell.weights[1] * weights.y + cell.weights[2] * weights.z};
  std::copy_n(&side.indices[cell.triangle * 3UL], 3, point.vertices.begin());
  return point;
}

PointLook MeshErrorMeter::look_of(const SurfacePoint& point) const {
  return paint_ == nullptr ? PointLook{} : paint_->look(point);
}

glm::vec3 MeshErrorMeter::skinned(std::uint32_t vertex, std::span<const glm::mat4x3> palette) const {
  const float* at = &surface_.positions[vertex * 3UL];
  const glm::vec4 position(at[0], at[1], at[2], 1.0F);
  if (palette.empty()) return glm::vec3(position);
  glm::vec3 sum(0.0F);
  const SkinInfluences& influences = surface_.influences[vertex];
  for (std::size_t i = 0; i < influences.entries.size(); ++i) {
    const float weight = influences.weights.at(i);
    if (weight != 0.0F) sum += weight * (palette[influences.entries.at(i)] * position);
  }
  return sum;
}

glm::vec3 MeshErrorMeter::position_of(const SurfacePoint& point, std::size_t pose) const {
  const std::vector<glm::vec3>& at = positions_[pose];
  return point.weights.x * at[point.vertices[0]] + point.weights.y * at[point.vertices[1]] +
         point.weights.z * at[point.vertices[2]];
}

}  // namespace throng::render
