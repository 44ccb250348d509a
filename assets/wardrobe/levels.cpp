#include "assets/wardrobe/levels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x3.hpp>

#include "assets/mannequin/clip.h"
#include "engine/render/mesh/mesh_error.h"
#include "engine/render/mesh/surface.h"
#include "engine/render/mesh/surface_simplifier.h"

namespace throng::wardrobe {
namespace {

using mannequin::joint_count;
using mannequin::Mesh;
using mannequin::MeshVertex;

std::vector<glm::mat4x3> palette_of(const mannequin::Pose& pose) {
  std::vector<glm::mat4x3> palette;
  const mannequin::WorldPose world = mannequin::world_pose(pose);
  for (std::size_t j = 0; j < joint_count; ++j) {
    const glm::dmat3 turn = glm::mat3_cast(world[j].rotation);
    const glm::dvec3 place = world[j].position - turn * mannequin::skeleton()[j].position;
    palette.emplace_back(glm::vec3(turn[0]), glm::vec3(turn[1]), glm::vec3(turn[2]), glm::vec3(place));
  }
  return palette;
}

/// The rest pose, then a moment of every clip.
const render::PosedPalettes& poses() {
  static const auto all = [] {
    render::PosedPalettes palettes{palette_of(mannequin::Pose())};
    for (const mannequin::Clip& clip : mannequin::make_clips()) {
      mannequin::Pose pose = clip.keys[clip.keys.size() * 2 / 5];
      pose.root = glm::dvec3(0);
      palettes.push_back(palette_of(pose));
    }
    return palettes;
  }();
  return all;
}

/// A mesh as the renderer's simplifier and meter read it.
class Measured {
 public:
  Measured(const Mesh& mesh, bool keeps_trims, const Held& held = {}) {
    for (const MeshVertex& vertex : mesh.vertices) add(vertex, keeps_trims);
    for (std::uint32_t v = 0; v < held.size(); ++v) {
      if (held[v]) hold(mesh.vertices[v], v);
    }
    for (const auto& triangle : mesh.triangles) indices_.insert(indices_.end(), triangle.begin(), triangle.end());
    materials_.assign(belongs_to_.size(), 0);
    data_.materials.resize(1);
    paint_ = std::make_unique<render::SurfacePaint>(surface_, materials_, data_);
    for (std::uint32_t v = 0; v < belongs_to_.size(); ++v) {
      colours_.push_back(paint_->look({.vertices = {v, v, v}}).color);
    }
    meter_ = std::make_unique<render::MeshErrorMeter>(view(), paint_.get(), poses());
  }
  Measured(const Measured&) = delete;
  Measured& operator=(const Measured&) = delete;

  [[nodiscard]] render::SkinnedSurfaceView view() const {
    return {.positions = positions_,
            .influences = influences_,
            .belongs_to = belongs_to_,
            .indices = indices_,
            .texture_coords = {},
            .colors = colours_,
            .face = face_};
  }
  [[nodiscard]] double error_of(const std::vector<std::uint32_t>& indices) const {
    return static_cast<double>(meter_->error_of(indices).surface);
  }
  [[nodiscard]] double extent() const { return static_cast<double>(meter_->extent()); }

 private:
  /// A point moves only to one that has all that it belongs to, so one that alone belongs to something stays.
  void hold(const MeshVertex& vertex, std::uint32_t number) {
    constexpr std::uint32_t alone = 1U << 24U;
    add(vertex, true);
    belongs_to_.back() = alone + number;
  }

  void add(const MeshVertex& vertex, bool keeps_trims) {
    positions_.insert(positions_.end(), {vertex.position.x, vertex.position.y, vertex.position.z});
    render::SkinInfluences influences{};
    for (std::size_t i = 0; i < 4; ++i) influences.entries[i] = vertex.joints[i];
    influences.weights = vertex.weights;
    influences_.push_back(influences);
    const auto region = static_cast<std::uint32_t>(vertex.region);
    belongs_to_.push_back(vertex.piece * 4096U + region * 256U +
                          (keeps_trims ? static_cast<std::uint32_t>(vertex.trim * 255.0F) : 0));
    const std::string& joint = mannequin::skeleton()[vertex.joints[0]].name;
    face_.push_back(joint.starts_with("head") || joint.starts_with("jaw") || joint.starts_with("eye") ? 1 : 0);
    render::SurfaceVertex look{};
    std::copy_n(&vertex.position.x, 3, look.position);
    for (std::size_t i = 0; i < 4; ++i) look.color[i] = static_cast<std::uint16_t>(vertex.colour[i] * 257);
    look.region = static_cast<std::uint8_t>(region);
    surface_.vertices.push_back(look);
  }

  std::vector<float> positions_;
  std::vector<render::SkinInfluences> influences_;
  std::vector<std::uint32_t> belongs_to_, indices_;
  std::vector<glm::vec3> colours_;
  std::vector<std::uint8_t> face_;
  std::vector<int> materials_;
  render::Surface surface_;
  render::CrowdMeshData data_;
  std::unique_ptr<render::SurfacePaint> paint_;
  std::unique_ptr<render::MeshErrorMeter> meter_;
};

Level level_of(const std::vector<std::uint32_t>& indices, double error) {
  constexpr double error_step = 1e-4;
  return {{indices.begin(), indices.end()}, std::ceil(error / error_step) * error_step};
}

/// Merges points until an error is reached: first in large steps, then in small ones. Hems are held firmly, and then
/// less so where that needs fewer triangles.
Level coarsest_within(const Measured& measured, double bound, std::size_t begin) {
  constexpr std::size_t fewest = 10;
  const double farthest = 0.2 * measured.extent();
  Level best;
  for (const double firmness_of_hems : {4.0, 1.0}) {
    render::SkinnedSurfaceView view = measured.view();
    view.open_edge_firmness = firmness_of_hems;
    render::SurfaceSimplifier simplifier(view);
    simplifier.reduce_to(best.indices.empty() ? begin : best.indices.size() / 3, farthest);
    double error = measured.error_of(simplifier.indices());
    if (error > bound) {
      if (!best.indices.empty()) continue;
      simplifier = render::SurfaceSimplifier(view);
      error = 0;
    }
    for (const double shrink : {0.72, 0.85, 0.95}) {
      while (simplifier.triangle_count() > fewest) {
        render::SurfaceSimplifier next = simplifier;
        next.reduce_to(static_cast<std::size_t>(static_cast<double>(simplifier.triangle_count()) * shrink), farthest);
        if (next.triangle_count() == simplifier.triangle_count()) break;
        const double next_error = measured.error_of(next.indices());
        if (next_error > bound) break;
        simplifier = std::move(next);
        error = next_error;
      }
    }
    best = level_of(simplifier.indices(), error);
  }
  return best;
}

/// Begins with the most triangles that a bound allows.
Level far_level(const Measured& measured, const render::SkinnedSurfaceView& view, const FarBound& bound) {
  constexpr double shrink = 0.9;
  render::SurfaceSimplifier simplifier(view);
  Level best{{}, std::numeric_limits<double>::infinity()};
  for (auto count = static_cast<double>(bound.triangles); count > 40; count *= shrink) {
    simplifier.reduce_to(static_cast<std::size_t>(count), 0.3);
    const double error = measured.error_of(simplifier.indices());
    if (error > bound.error && !best.indices.empty()) break;
    best = level_of(simplifier.indices(), error);
    if (error > bound.error) break;
  }
  return best;
}

bool is_better(const Level& one, const Level& other, const FarBound& bound) {
  const bool keeps_one = one.error <= bound.error, keeps_other = other.error <= bound.error;
  if (keeps_one != keeps_other) return keeps_one;
  return keeps_one ? one.indices.size() < other.indices.size() : one.error < other.error;
}

}  // namespace

Level whole_level(const Mesh& mesh) {
  Level level;
  for (const auto& triangle : mesh.triangles)
    level.indices.insert(level.indices.end(), triangle.begin(), triangle.end());
  return level;
}

Level finest_level(const Mesh& mesh, const Held& held) {
  constexpr double flat = 0.0005;
  const Measured measured(mesh, true, held);
  render::SurfaceSimplifier simplifier(measured.view());
  simplifier.reduce_to(0, flat);
  return level_of(simplifier.indices(), 0);
}

std::vector<Level> coarser_levels(const Mesh& mesh, std::span<const double> bounds, const Level& finest,
                                  const Held& held) {
  std::vector<Level> levels;
  auto finer = mesh.triangles.size();
  const std::vector<std::uint32_t> finest_indices(finest.indices.begin(), finest.indices.end());
  for (std::size_t l = 0; l < bounds.size(); ++l) {
    const Measured measured(mesh, l == 0, held);
    levels.push_back(coarsest_within(measured, bounds[l], finer));
    if (l > 0 && levels[l - 1].indices.size() < levels[l].indices.size()) levels[l] = levels[l - 1];
    if (l == 0 && finest.indices.size() < levels[l].indices.size()) {
      const double error = measured.error_of(finest_indices);
      if (error <= bounds[l]) levels[l] = level_of(finest_indices, error);
    }
    finer = levels[l].indices.size() / 3;
  }
  return levels;
}

std::vector<std::size_t> keep_used(Mesh& mesh, std::vector<Level>& levels) {
  std::vector<bool> used(mesh.vertices.size());
  for (const Level& level : levels) {
    for (const std::uint16_t index : level.indices) used[index] = true;
  }
  Mesh kept;
  std::vector<std::size_t> old;
  std::vector<std::uint16_t> moved(used.size());
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    moved[v] = static_cast<std::uint16_t>(old.size());
    old.push_back(v);
    kept.vertices.push_back(mesh.vertices[v]);
  }
  for (Level& level : levels) {
    for (std::uint16_t& index : level.indices) index = moved[index];
  }
  const std::vector<std::uint16_t>& finest = levels.front().indices;
  for (std::size_t i = 0; i < finest.size(); i += 3) {
    kept.triangles.push_back({finest[i], finest[i + 1], finest[i + 2]});
  }
  mesh = std::move(kept);
  return old;
}

std::vector<Level> far_levels(const Mesh& mesh, std::span<const FarBound> bounds) {
  const Measured measured(mesh, false);
  std::vector<Level> levels;
  for (const FarBound& bound : bounds) {
    // A finer level may happen to be as coarse.
    Level best = levels.empty() ? Level{{}, std::numeric_limits<double>::infinity()} : levels.back();
    for (const auto& [firmness_of_hems, keeps_colours] :
         {std::pair{4.0, true}, {0.3, true}, {0.05, true}, {0.3, false}}) {
      render::SkinnedSurfaceView view = measured.view();
      view.face_firmness = 1;
      view.open_edge_firmness = firmness_of_hems;
      if (!keeps_colours) view.colors = {};
      const Level level = far_level(measured, view, bound);
      if (is_better(level, best, bound)) best = level;
    }
    levels.push_back(std::move(best));
  }
  return levels;
}

}  // namespace throng::wardrobe
