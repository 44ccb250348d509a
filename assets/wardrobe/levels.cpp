#include "assets/wardrobe/levels.h"

#include <algorithm>
#include <cmath>

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
  explicit Measured(const Mesh& mesh) {
    for (const MeshVertex& vertex : mesh.vertices) add(vertex);
    for (const auto& triangle : mesh.triangles) indices_.insert(indices_.end(), triangle.begin(), triangle.end());
    materials_.assign(mesh.vertices.size(), 0);
    data_.materials.resize(1);
    paint_ = std::make_unique<render::SurfacePaint>(surface_, materials_, data_);
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
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
  void add(const MeshVertex& vertex) {
    positions_.insert(positions_.end(), {vertex.position.x, vertex.position.y, vertex.position.z});
    render::SkinInfluences influences{};
    for (std::size_t i = 0; i < 4; ++i) influences.entries[i] = vertex.joints[i];
    influences.weights = vertex.weights;
    influences_.push_back(influences);
    const auto region = static_cast<std::uint32_t>(vertex.region);
    belongs_to_.push_back(vertex.piece * 4096U + region * 256U + static_cast<std::uint32_t>(vertex.trim * 255.0F));
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

}  // namespace

Level whole_level(const Mesh& mesh) {
  Level level;
  for (const auto& triangle : mesh.triangles)
    level.indices.insert(level.indices.end(), triangle.begin(), triangle.end());
  return level;
}

std::vector<Level> coarser_levels(const Mesh& mesh, std::span<const double> bounds) {
  constexpr double shrink = 0.85;
  constexpr std::size_t fewest = 12;
  const Measured measured(mesh);
  render::SurfaceSimplifier simplifier(measured.view());
  std::vector<Level> levels(bounds.size(), whole_level(mesh));
  auto target = static_cast<double>(mesh.triangles.size());
  while (target > fewest) {
    target *= shrink;
    const std::size_t before = simplifier.triangle_count();
    simplifier.reduce_to(static_cast<std::size_t>(target), 0.2 * measured.extent());
    if (simplifier.triangle_count() == before) break;
    const double error = measured.error_of(simplifier.indices());
    if (error > bounds.back()) break;
    for (std::size_t l = 0; l < bounds.size(); ++l) {
      if (error <= bounds[l]) levels[l] = level_of(simplifier.indices(), error);
    }
  }
  return levels;
}

std::vector<Level> levels_of_size(const Mesh& mesh, std::span<const std::size_t> triangles) {
  const Measured measured(mesh);
  render::SkinnedSurfaceView view = measured.view();
  view.face_firmness = 3;
  render::SurfaceSimplifier simplifier(view);
  std::vector<Level> levels;
  for (const std::size_t count : triangles) {
    simplifier.reduce_to(count, 0.3);
    levels.push_back(level_of(simplifier.indices(), measured.error_of(simplifier.indices())));
  }
  return levels;
}

}  // namespace throng::wardrobe
