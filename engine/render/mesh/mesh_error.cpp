#include "engine/render/mesh/mesh_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace throng::render {
namespace {

constexpr float cells_of_extent = 64.0F;      // an edge of colour is found to about 3 cm on a person
constexpr float farthest_of_extent = 0.125F;  // farther counterparts are not looked for
constexpr float least_of_extent = 0.002F;     // the samples do not resolve less
constexpr std::size_t most_sampled_cells = 1000;
// A mesh of so few of the triangles is off in large patches. Fewer samples find them as well, and each takes longer.
// An odd number takes samples inside cells and samples in corners.
constexpr std::size_t few_of_the_triangles = 20, one_sample_of = 5;
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

/// Returns directions that are spread evenly over a sphere. None has a component that is 0.
std::array<glm::vec3, 18> make_view_directions() {
  constexpr float golden_angle = 2.39996F;
  std::array<glm::vec3, 18> directions{};
  const auto count = static_cast<float>(directions.size());
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const float y = (2.0F * static_cast<float>(i) + 1.0F) / count - 1.0F, radius = std::sqrt(1.0F - y * y);
    const float angle = golden_angle * static_cast<float>(i) + 0.1F;
    directions.at(i) = {radius * std::cos(angle), y, radius * std::sin(angle)};
  }
  return directions;
}

std::span<const glm::vec3> view_directions() {
  static const std::array directions = make_view_directions();
  return directions;
}

/// Returns the normal, as long as twice the area.
glm::vec3 normal_of(const SurfaceCell& cell) {
  return glm::cross(cell.corners[1] - cell.corners[0], cell.corners[2] - cell.corners[0]);
}

float area_of(const SurfaceCell& cell) { return glm::length(normal_of(cell)) / 2.0F; }

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
  least_error_ = extent_ * least_of_extent;
  full_ = side_of(surface.indices);
  samples_ = samples_of(full_);
  for (Sample& sample : samples_) sample.seen_area = seen_area(full_, sample);
  std::erase_if(samples_, [](const Sample& sample) { return sample.seen_area == 0.0F; });
}

MeshError MeshErrorMeter::error_of(std::span<const std::uint32_t> indices) const {
  const bool is_coarse = indices.size() * few_of_the_triangles < full_.indices.size();
  const std::size_t stride = is_coarse ? one_sample_of : 1;
  const Side coarse = side_of(indices);
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < samples_.size(); i += stride) pair(samples_[i], full_, coarse, pairs);
  const std::vector<Sample> of_coarse = samples_of(coarse);
  for (std::size_t i = 0; i < of_coarse.size(); i += stride) pair(of_coarse[i], coarse, full_, pairs);
  for (Pair& pair : pairs) pair.seen_area *= static_cast<float>(stride);
  const float surface = usual_error(pairs);
  if (surface_.face.empty()) return {surface, surface};
  std::erase_if(pairs, [](const Pair& pair) { return !pair.on_face; });
  return {surface, usual_error(pairs)};
}

float MeshErrorMeter::largest_error() const { return extent_ * farthest_of_extent; }

/// Returns the error that 99% of the poses do not exceed.
float MeshErrorMeter::usual_error(std::span<const Pair> pairs) const {
  std::vector<float> errors;
  for (std::size_t pose = 0; pose < positions_.size(); ++pose) errors.push_back(error_in_pose(pairs, pose));
  const auto kept = static_cast<std::ptrdiff_t>(std::ceil(poses_kept * static_cast<double>(errors.size()))) - 1;
  std::nth_element(errors.begin(), errors.begin() + kept, errors.end());
  return std::max(errors[static_cast<std::size_t>(kept)], least_error_);
}

float MeshErrorMeter::error_in_pose(std::span<const Pair> pairs, std::size_t pose) const {
  std::vector<std::pair<float, float>> distances_and_areas;
  for (const Pair& pair : pairs) {
    const float distance = glm::distance(position_of(pair.here, pose), position_of(pair.there, pose));
    distances_and_areas.emplace_back(std::max(distance, pair.recolored), pair.seen_area);
  }
  std::ranges::sort(distances_and_areas, std::ranges::greater{});
  float area = 0.0F;
  for (const auto& [distance, seen_area] : distances_and_areas) {
    area += seen_area;
    if (area >= distance * distance) return distance;
  }
  return 0.0F;
}

MeshErrorMeter::Side MeshErrorMeter::side_of(std::span<const std::uint32_t> indices) const {
  const float longest_edge = std::max(extent_ / cells_of_extent, 1e-9F);
  Side side{.indices = indices, .tree = CellTree({}), .looks = {}, .seen = {}};
  std::vector<SurfaceCell> cells = cut_into_cells(positions_.front(), indices, longest_edge);
  for (SurfaceCell& cell : cells) cell.hides = !look_of(point_of(side, cell, middle)).seen_through;
  side.tree = CellTree(std::move(cells));
  for (const SurfaceCell& cell : side.tree.cells()) side.looks.push_back(look_of(point_of(side, cell, middle)));
  side.seen = std::make_unique<std::atomic<Seen>[]>(side.tree.cells().size());
  return side;
}

std::vector<MeshErrorMeter::Sample> MeshErrorMeter::samples_of(const Side& side) const {
  std::vector<Sample> samples;
  const std::span cells = side.tree.cells();
  const std::size_t stride = stride_for(cells.size(), most_sampled_cells);
  for (std::size_t i = 0; i < cells.size(); i += stride) {
    glm::vec3 corner(0.0F);  // A surface reaches farthest in its corners.
    corner[static_cast<glm::length_t>(i % 3)] = 1.0F;
    for (const glm::vec3& weights : {middle, corner}) {
      Sample sample = sample_at(side, cells[i], weights);
      sample.area = area_of(cells[i]) * static_cast<float>(stride) / 2.0F;
      if (!sample.look.cut_out) samples.push_back(sample);
    }
  }
  return samples;
}

MeshErrorMeter::Sample MeshErrorMeter::sample_at(const Side& side, const SurfaceCell& cell,
                                                 const glm::vec3& weights) const {
  // A corner lies on the borders of several colours: a point beside it says whose it is.
  constexpr float beside = 0.8F;
  const glm::vec3 inside = weights * beside + middle * (1.0F - beside);
  return {.cell = &cell,
          .weights = weights,
          .point = point_of(side, cell, weights),
          .look = look_of(point_of(side, cell, inside)),
          .seen_area = {}};
}

float MeshErrorMeter::seen_area(const Side& side, const Sample& sample) const {
  int seen = 0;
  for (const glm::vec3& direction : view_directions()) {
    seen += static_cast<int>(is_seen_from(direction, side, *sample.cell, sample.weights, sample.look.double_sided));
  }
  constexpr float share_in_front = 0.5F;
  const float share = static_cast<float>(seen) / static_cast<float>(view_directions().size()) / share_in_front;
  return sample.area * std::min(share, 1.0F);
}

// A point is seen from a direction if light comes to it from there.
bool MeshErrorMeter::is_seen_from(const glm::vec3& direction, const Side& side, const SurfaceCell& cell,
                                  const glm::vec3& weights, bool double_sided) const {
  if (!double_sided && glm::dot(direction, normal_of(cell)) <= 0.0F) return false;
  constexpr float off_the_surface = 1e-4F;  // of the extent
  const glm::vec3 inside = weights * 0.9F + middle * 0.1F;
  return !side.tree.meets_a_cell(position_in(cell, inside) + direction * (extent_ * off_the_surface), direction);
}

void MeshErrorMeter::pair(const Sample& sample, const Side& own, const Side& other, std::vector<Pair>& pairs) const {
  const float most = largest_error();
  const auto distance = [&](const SurfaceCell& cell, const glm::vec3& weights, float below) {
    return largest_distance(sample.point, point_of(other, cell, weights), below);
  };
  const auto closest = other.tree.closest(position_of(sample.point, 0), most, distance);
  Pair found{.here = sample.point, .there = sample.point, .recolored = most};
  if (closest.cell != nullptr) {
    found.there = point_of(other, *closest.cell, closest.weights);
    found.recolored = recolored_by(sample, look_of(found.there), own, other);
    if (std::max(closest.distance, found.recolored) <= least_error_) return;
  }
  found.seen_area = sample.seen_area.value_or(0.0F);
  if (!sample.seen_area) found.seen_area = seen_area(own, sample);
  found.on_face = is_on_face(sample.point);
  if (found.seen_area > 0.0F) pairs.push_back(found);
}

bool MeshErrorMeter::is_on_face(const SurfacePoint& point) const {
  return !surface_.face.empty() &&
         std::ranges::any_of(point.vertices, [this](std::uint32_t vertex) { return surface_.face[vertex] != 0; });
}

float MeshErrorMeter::recolored_by(const Sample& sample, const PointLook& look, const Side& own,
                                   const Side& other) const {
  if (look_alike(look, sample.look)) return 0.0F;
  const float most = largest_error();
  const float in_other = distance_to_alike(sample.point, sample.look, other, most);
  if (in_other * 2.0F <= least_error_) return 0.0F;
  // A strip of colour is lost, and the sample is this far from the nearer of its edges.
  const float to_edge = distance_to_alike(sample.point, look, own, in_other);
  return std::min(to_edge * 2.0F, most);
}

bool MeshErrorMeter::is_seen(const Side& side, const SurfaceCell& cell) const {
  std::atomic<Seen>& known = side.seen[static_cast<std::size_t>(&cell - side.tree.cells().data())];
  if (const Seen seen = known.load(std::memory_order_relaxed); seen != Seen::unknown) return seen == Seen::yes;
  const auto from = [&](const glm::vec3& direction) { return is_seen_from(direction, side, cell, middle, false); };
  // Light from straight ahead is the likeliest to arrive.
  const glm::vec3 normal = normal_of(cell);
  const glm::vec3 ahead = *std::ranges::max_element(
      view_directions(), {}, [&](const glm::vec3& direction) { return glm::dot(direction, normal); });
  const bool seen = from(ahead) || std::ranges::any_of(view_directions(), from);
  known.store(seen ? Seen::yes : Seen::no, std::memory_order_relaxed);
  return seen;
}

float MeshErrorMeter::largest_distance(const SurfacePoint& a, const SurfacePoint& b, float below) const {
  float largest = 0.0F;
  for (std::size_t pose = 0; pose < positions_.size() && largest < below; ++pose) {
    largest = std::max(largest, glm::distance(position_of(a, pose), position_of(b, pose)));
  }
  return largest;
}

float MeshErrorMeter::distance_to_alike(const SurfacePoint& point, const PointLook& look, const Side& side,
                                        float limit) const {
  const glm::vec3 from = position_of(point, 0);
  const std::span cells = side.tree.cells();
  const auto distance = [&](const SurfaceCell& cell, glm::vec3& weights, float below) {
    if (!look_alike(look_of(point_of(side, cell, weights)), look)) {
      weights = middle;
      if (!look_alike(side.looks[static_cast<std::size_t>(&cell - cells.data())], look)) return INFINITY;
    }
    // The skin that an eye covers is not where its edge is.
    const float away = glm::distance(position_in(cell, weights), from);
    return away < below && is_seen(side, cell) ? away : INFINITY;
  };
  return side.tree.closest(from, limit, distance).distance;
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
  if (palette.empty()) return {at[0], at[1], at[2]};
  const glm::vec4 position(at[0], at[1], at[2], 1.0F);
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
