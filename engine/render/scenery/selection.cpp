#include "engine/render/scenery/selection.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "throng/render/camera.h"

namespace throng::render {
namespace {

constexpr std::size_t instances_a_cluster = 48;
constexpr std::size_t side_planes = 4;

glm::vec3 position_of(const SceneryVertex& vertex) {
  return {vertex.position[0], vertex.position[1], vertex.position[2]};
}

// Puts a zero before each bit.
std::uint32_t spread(std::uint32_t bits) {
  bits = (bits | (bits << 8U)) & 0x00FF00FFU;
  bits = (bits | (bits << 4U)) & 0x0F0F0F0FU;
  bits = (bits | (bits << 2U)) & 0x33333333U;
  return (bits | (bits << 1U)) & 0x55555555U;
}

float largest_scale(const glm::mat4x3& place) {
  return std::max({glm::length(place[0]), glm::length(place[1]), glm::length(place[2])});
}

// Numbers the points of a square so that neighbours mostly have numbers that are close.
std::uint32_t along_curve(const glm::vec3& point, const glm::vec3& lowest, const glm::vec3& highest) {
  const auto share = [](float at, float low, float high) {
    return static_cast<std::uint32_t>(65535.0F * (at - low) / std::max(high - low, 1e-3F));
  };
  return spread(share(point.x, lowest.x, highest.x)) | (spread(share(point.z, lowest.z, highest.z)) << 1U);
}

}  // namespace

SceneryShape shape_of(const SceneryMeshData& mesh) {
  glm::vec3 lowest(std::numeric_limits<float>::max()), highest(std::numeric_limits<float>::lowest());
  for (const SceneryVertex& vertex : mesh.vertices) {
    lowest = glm::min(lowest, position_of(vertex));
    highest = glm::max(highest, position_of(vertex));
  }
  SceneryShape shape;
  if (!mesh.vertices.empty()) shape.middle = (lowest + highest) * 0.5F;
  for (const SceneryVertex& vertex : mesh.vertices) {
    shape.radius = std::max(shape.radius, glm::distance(position_of(vertex), shape.middle));
  }
  for (const SceneryLodData& lod : mesh.lods) shape.errors.push_back(lod.error);
  return shape;
}

SceneryView::SceneryView(const CameraView& camera, float picture_height)
    : planes_(frustum_planes(camera)),
      plane_count_(planes_.size()),
      eye_(camera.position),
      a_metre_away_(2.0F / (picture_height * camera.projection[1][1])) {}

SceneryView::SceneryView(const glm::mat4& view_projection, float pixel_metres)
    : planes_(frustum_planes({.view = glm::mat4(1.0F), .projection = view_projection})),
      plane_count_(side_planes),
      everywhere_(pixel_metres) {}

bool SceneryView::sees_sphere(const glm::vec3& middle, float radius) const {
  return std::all_of(planes_.begin(), planes_.begin() + static_cast<std::ptrdiff_t>(plane_count_),
                     [&](const glm::vec4& plane) { return glm::dot(glm::vec3(plane), middle) + plane.w >= -radius; });
}

bool SceneryView::sees_box(const glm::vec3& lowest, const glm::vec3& highest) const {
  return std::all_of(planes_.begin(), planes_.begin() + static_cast<std::ptrdiff_t>(plane_count_),
                     [&](const glm::vec4& plane) {
                       const glm::vec3 inwards(plane);
                       const glm::vec3 farthest = glm::mix(lowest, highest, glm::step(glm::vec3(0.0F), inwards));
                       return glm::dot(inwards, farthest) + plane.w >= 0.0F;
                     });
}

float SceneryView::metres_a_pixel(const glm::vec3& middle, float radius) const {
  return everywhere_ + a_metre_away_ * std::max(glm::distance(eye_, middle) - radius, Camera::near_distance);
}

std::uint32_t SceneryView::ring(const glm::vec3& middle, float radius) const {
  if (everywhere_ > 0.0F) return 0;
  const float metres = std::max(glm::distance(eye_, middle) - radius, 1.0F);
  return std::min(static_cast<std::uint32_t>(std::ilogb(metres * metres)), scenery_rings - 1);
}

float SceneryView::metres_a_pixel_in(const glm::vec3& lowest, const glm::vec3& highest) const {
  return everywhere_ + a_metre_away_ * glm::distance(eye_, glm::clamp(eye_, lowest, highest));
}

std::vector<std::uint32_t> ScenerySelection::place(std::span<const SceneryInstance> instances,
                                                   std::span<const SceneryShape> shapes) {
  std::vector<Placed> placed;
  glm::vec3 lowest(std::numeric_limits<float>::max()), highest(std::numeric_limits<float>::lowest());
  for (const SceneryInstance& instance : instances) {
    assert(instance.mesh < shapes.size());
    const SceneryShape& shape = shapes[instance.mesh];
    const float scale = largest_scale(instance.place);
    const glm::vec3 middle = instance.place * glm::vec4(shape.middle, 1.0F);
    placed.push_back({middle, shape.radius * scale, scale, instance.mesh});
    lowest = glm::min(lowest, middle);
    highest = glm::max(highest, middle);
  }
  std::vector<std::uint32_t> keys, order(placed.size());
  for (const Placed& each : placed) keys.push_back(along_curve(each.middle, lowest, highest));
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, [&](std::uint32_t a, std::uint32_t b) { return keys[a] < keys[b]; });
  placed_.clear();
  for (const std::uint32_t instance : order) placed_.push_back(placed[instance]);
  gather_clusters();
  first_slots_.clear();
  errors_.clear();
  for (const SceneryShape& shape : shapes) {
    first_slots_.push_back(static_cast<std::uint32_t>(errors_.size()));
    errors_.insert(errors_.end(), shape.errors.begin(), shape.errors.end());
  }
  first_slots_.push_back(static_cast<std::uint32_t>(errors_.size()));
  counts_.assign(scenery_rings * errors_.size(), 0);
  runs_.assign(counts_.size(), {});
  seen_.assign(placed_.size(), {});
  chosen_.assign(placed_.size(), 0);
  run_count_ = chosen_count_ = 0;
  return order;
}

void ScenerySelection::gather_clusters() {
  clusters_.clear();
  for (std::size_t first = 0; first < placed_.size(); first += instances_a_cluster) {
    const std::size_t end = std::min(first + instances_a_cluster, placed_.size());
    Cluster cluster{placed_[first].middle, placed_[first].middle, 0.0F, static_cast<std::uint32_t>(first),
                    static_cast<std::uint32_t>(end)};
    for (std::size_t i = first; i < end; ++i) {
      cluster.lowest = glm::min(cluster.lowest, placed_[i].middle - placed_[i].radius);
      cluster.highest = glm::max(cluster.highest, placed_[i].middle + placed_[i].radius);
      cluster.largest_radius = std::max(cluster.largest_radius, placed_[i].radius);
    }
    clusters_.push_back(cluster);
  }
}

void ScenerySelection::see(const SceneryView& view, std::uint32_t instance, std::uint32_t coarser) {
  const Placed& placed = placed_[instance];
  if (!view.sees_sphere(placed.middle, placed.radius)) return;
  const float pixel = view.metres_a_pixel(placed.middle, placed.radius);
  if (2.0F * placed.radius < least_scenery_pixels * pixel) return;
  const std::uint32_t first = first_slots_[placed.mesh], end = first_slots_[placed.mesh + 1];
  std::uint32_t slot = first;
  while (slot + 1 < end && errors_[slot + 1] * placed.scale <= scenery_error_pixels * pixel) ++slot;
  if (first == end) return;
  slot = std::min(slot + coarser, end - 1);
  const auto slots = static_cast<std::uint32_t>(errors_.size());
  const std::uint32_t place = view.ring(placed.middle, placed.radius) * slots + slot;
  seen_[seen_count_++] = {instance, place};
  ++counts_[place];
}

// Near things hide far ones, so they come first. The things of a ring and a slot are one run.
void ScenerySelection::sort_by_distance() {
  run_count_ = 0;
  std::uint32_t first = 0;
  std::size_t place = 0;
  for (std::uint32_t ring = 0; ring < scenery_rings; ++ring) {
    for (std::uint32_t mesh = 0; mesh + 1 < first_slots_.size(); ++mesh) {
      for (std::uint32_t slot = first_slots_[mesh]; slot < first_slots_[mesh + 1]; ++slot, ++place) {
        const std::uint32_t count = counts_[place];
        counts_[place] = first;  // from here on: where the next one goes
        if (count > 0) runs_[run_count_++] = {mesh, slot - first_slots_[mesh], first, count};
        first += count;
      }
    }
  }
  for (std::size_t i = 0; i < seen_count_; ++i) chosen_[counts_[seen_[i].place]++] = seen_[i].instance;
  chosen_count_ = seen_count_;
}

void ScenerySelection::choose(const SceneryView& view, std::uint32_t coarser) {
  seen_count_ = 0;
  std::ranges::fill(counts_, 0U);
  for (const Cluster& cluster : clusters_) {
    if (!view.sees_box(cluster.lowest, cluster.highest)) continue;
    const float pixel = view.metres_a_pixel_in(cluster.lowest, cluster.highest);
    if (2.0F * cluster.largest_radius < least_scenery_pixels * pixel) continue;
    for (std::uint32_t instance = cluster.first; instance < cluster.end; ++instance) see(view, instance, coarser);
  }
  sort_by_distance();
}

}  // namespace throng::render
