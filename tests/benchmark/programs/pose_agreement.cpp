#include "tests/benchmark/programs/pose_agreement.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "engine/anim/bake/surface.h"

namespace throng::app {
namespace {

constexpr std::size_t most_agents = 1000;

glm::dvec3 carried(const anim::PaletteMatrix& matrix, const glm::dvec3& point) {
  glm::dvec3 result(0.0);
  for (int row = 0; row < 3; ++row) {
    result[row] = static_cast<double>(matrix.rows[row][3]);
    for (int column = 0; column < 3; ++column) {
      result[row] += static_cast<double>(matrix.rows[row][column]) * point[column];
    }
  }
  return result;
}

const anim::PaletteMatrix* palette_of(const BenchPalettes& palettes, std::size_t agent) {
  return reinterpret_cast<const anim::PaletteMatrix*>(palettes.of(agent).memory());
}

}  // namespace

PoseAgreement::PoseAgreement(const anim::Model& model, const BenchPalettes& palettes, std::size_t agents)
    : palettes_(&palettes) {
  if (!model.skeleton.rigid) return;
  for (const anim::SurfacePoint& point : anim::make_surface_proxy(model).points) {
    const auto bone = static_cast<std::size_t>(point.bone);
    points_.push_back({bone, model.skeleton.references[bone].origin + point.offset});
  }
  for (std::size_t agent = 0; agent < std::min(agents, most_agents); ++agent) {
    const anim::PaletteMatrix* const palette = palette_of(palettes, agent);
    kept_.emplace_back(palette, palette + model.skeleton.bone_count());
  }
}

double PoseAgreement::off_by(std::size_t agent) const {
  const anim::PaletteMatrix* const palette = palette_of(*palettes_, agent);
  double largest = 0.0;
  for (const Point& point : points_) {
    const glm::dvec3 before = carried(kept_[agent][point.bone], point.place);
    largest = std::max(largest, glm::distance(before, carried(palette[point.bone], point.place)));
  }
  return largest;
}

double PoseAgreement::off_by() const {
  std::vector<double> of_agents;
  for (std::size_t agent = 0; agent < kept_.size(); ++agent) of_agents.push_back(off_by(agent));
  const auto place = of_agents.begin() + static_cast<std::ptrdiff_t>(of_agents.size() * 9 / 10);
  std::ranges::nth_element(of_agents, place);
  return *place;
}

}  // namespace throng::app
