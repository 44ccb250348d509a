#include "engine/anim/kernel/palette/surface_error.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <glm/geometric.hpp>

namespace throng::anim {
namespace {

constexpr float nearest_to_divide = 1e-3F;  // of clip w: metres in front of the camera

glm::vec4 skinned(std::span<const PointInfluence> influences, std::span<const PaletteMatrix> palette) {
  // Four lanes multiply one column after the other, and are added at the end.
  float sums[3][4] = {};
  for (const PointInfluence& influence : influences) {
    const PaletteMatrix& matrix = palette[influence.entry];
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column)
        sums[row][column] += matrix.rows[row][column] * influence.weighted[column];
    }
  }
  const auto sum = [&](int row) { return (sums[row][0] + sums[row][1]) + (sums[row][2] + sums[row][3]); };
  return {sum(0), sum(1), sum(2), 1.0F};
}

bool in_picture(const glm::vec4& clip) {
  return clip.w > nearest_to_divide && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w;
}

glm::vec2 pixels_of(const glm::vec4& clip, const glm::vec2& half_size) {
  return glm::vec2(clip) / std::max(clip.w, nearest_to_divide) * half_size;
}

void blend_packed(const ShownPaletteJob& job) {
  const auto* const from = reinterpret_cast<const PackedPaletteEntry*>(job.from.memory());
  const auto* const to = reinterpret_cast<const PackedPaletteEntry*>(job.to.memory());
  for (std::size_t entry = 0; entry < job.shown.size(); ++entry) {
    const std::size_t kept = job.kept_entries[entry];
    job.shown[entry] = unpack_between(from[kept], to[kept], job.packing[kept], job.blend);
  }
}

void blend_matrices(const ShownPaletteJob& job) {
  const auto* const from_matrices = reinterpret_cast<const PaletteMatrix*>(job.from.memory());
  const auto* const to_matrices = reinterpret_cast<const PaletteMatrix*>(job.to.memory());
  for (std::size_t entry = 0; entry < job.shown.size(); ++entry) {
    const std::size_t kept = job.kept_entries[entry];
    const float* const from = from_matrices[kept].rows[0];
    const float* const to = to_matrices[kept].rows[0];
    float* const out = job.shown[entry].rows[0];
    for (int i = 0; i < 12; ++i) out[i] = from[i] * (1.0F - job.blend) + to[i] * job.blend;
  }
}

}  // namespace

void blend_shown_palette(const ShownPaletteJob& job) {
  assert(is_valid(job));
  job.packing.empty() ? blend_matrices(job) : blend_packed(job);
}

float blend_of(std::uint32_t blend_start, std::uint32_t blend_duration, std::uint32_t now) {
  const std::uint32_t elapsed = now - blend_start;
  return elapsed >= blend_duration ? 1.0F : static_cast<float>(elapsed) / static_cast<float>(blend_duration);
}

void measure_surface(const SurfacePoints& points, std::span<const PaletteMatrix> shown,
                     std::span<const PaletteMatrix> exact, const ModelOnScreen& screen, SurfaceErrors& errors) {
  assert(points.count() <= most_surface_points);
  errors.in_picture.reset();
  float largest = 0.0F;
  for (std::size_t point = 0; point < points.count(); ++point) {
    const glm::vec4 is = screen.model_to_clip * skinned(points.of(point), shown);
    const glm::vec4 should_be = screen.model_to_clip * skinned(points.of(point), exact);
    if (!in_picture(is) && !in_picture(should_be)) continue;
    const glm::vec2 apart = pixels_of(is, screen.half_size) - pixels_of(should_be, screen.half_size);
    errors.in_picture.set(point);
    errors.pixels[point] = apart;
    largest = std::max(largest, glm::dot(apart, apart));
  }
  errors.largest = std::sqrt(largest);
}

float largest_change(const SurfaceErrors& before, const SurfaceErrors& now) {
  const auto in_both = before.in_picture & now.in_picture;
  float largest = 0.0F;
  for (std::size_t point = 0; point < most_surface_points; ++point) {
    if (!in_both[point]) continue;
    const glm::vec2 change = now.pixels[point] - before.pixels[point];
    largest = std::max(largest, glm::dot(change, change));
  }
  return std::sqrt(largest);
}

}  // namespace throng::anim
