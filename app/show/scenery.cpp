#include "app/show/scenery.h"

#include <algorithm>
#include <utility>

#include "app/people/crowd/crowd.h"
#include "app/people/place/plan_mesh.h"
#include "app/show/stage/stage.h"

namespace throng::app {
namespace {

constexpr glm::vec3 lantern{11.0F, 7.6F, 4.2F}, shop{2.6F, 1.9F, 1.15F}, spotlight{9.0F, 8.6F, 7.8F};
constexpr glm::vec3 flood{720.0F, 740.0F, 760.0F};

/// A lamp of a prop, at a place of the prop's own.
struct LampOfProp {
  Prop prop;
  glm::vec3 place;
  glm::vec3 color;
};

constexpr LampOfProp lamps_of_props[] = {
    {Prop::lamp, {0.0F, 3.7F, 0.0F}, lantern},       {Prop::kiosk, {0.0F, 3.0F, 0.0F}, lantern},
    {Prop::arcade_bay, {0.0F, 3.2F, 0.6F}, shop},    {Prop::facade_a, {0.0F, 3.0F, 1.2F}, shop},
    {Prop::facade_b, {0.0F, 3.0F, 1.2F}, shop},      {Prop::facade_c, {0.0F, 3.0F, 1.2F}, shop},
    {Prop::facade_d, {0.0F, 3.0F, 1.2F}, shop},      {Prop::facade_e, {0.0F, 3.0F, 1.2F}, shop},
    {Prop::facade_corner, {0.0F, 3.0F, 1.2F}, shop}, {Prop::stand, {0.0F, 3.0F, 1.5F}, spotlight},
    {Prop::flood_light, {0.0F, 26.0F, 0.0F}, flood}, {Prop::arcade_corner, {0.0F, 3.2F, 0.6F}, shop},
};

void add_lamps(const PlacedProp& prop, std::vector<render::SceneryLamp>& lamps) {
  for (const LampOfProp& lamp : lamps_of_props) {
    if (lamp.prop == prop.prop) lamps.push_back({prop.place * glm::vec4(lamp.place, 1.0F), lamp.color});
  }
}

}  // namespace

Status Scenery::load(std::vector<render::SceneryMeshData> props, render::Renderer& renderer) {
  loaded_ = std::move(props);
  for (std::size_t prop = 0; prop < prop_count; ++prop) {
    const auto mesh = std::ranges::find(loaded_, prop_names[prop], &render::SceneryMeshData::name);
    if (mesh != loaded_.end()) meshes_[prop] = static_cast<std::uint32_t>(mesh - loaded_.begin());
  }
  placed_.reset(), planned_.reset(), plan_mesh_.reset();
  if (auto loaded = renderer.load_scenery(loaded_); !loaded) return Error{loaded.error().message};
  return Done{};
}

Status Scenery::load_plan_of(const Stage& stage, render::Renderer& renderer) {
  if (planned_ == stage.trajectories()) return Done{};
  planned_ = stage.trajectories();
  placed_.reset();
  if (plan_mesh_) loaded_.resize(*plan_mesh_);
  plan_mesh_.reset();
  lines_left_out_ = 0;
  if (planned_ != nullptr && !planned_->plan.is_empty()) {
    render::SceneryMeshData mesh = plan_mesh(planned_->plan);
    if (mesh.vertices.empty()) {
      constexpr std::size_t few = 1000;  // are never too many; if nothing is drawn of them, they have no length
      const std::size_t lines = plan_lines(planned_->plan);
      lines_left_out_ = lines > few ? lines : 0;
    } else {
      plan_mesh_ = static_cast<std::uint32_t>(loaded_.size()), loaded_.push_back(std::move(mesh));
    }
  }
  if (auto loaded = renderer.load_scenery(loaded_); !loaded) return Error{loaded.error().message};
  return Done{};
}

Status Scenery::follow(const Stage& stage, render::Renderer& renderer) {
  if (Status loaded = load_plan_of(stage, renderer); !loaded) return loaded;
  const Tuning& tuning = stage.tuning();
  const Crowd& crowd = stage.crowd();
  const CharacterRoles& roles = crowd.laid_out_for();
  const Trajectories* const recorded = tuning.scene == Scene::tracks ? planned_.get() : nullptr;
  const Cause cause{tuning.scene,       crowd.size(),     tuning.seed,    roles.spacing(), roles.walk_speed,
                    roles.walk_seconds, roles.can_walk(), tuning.clothes, recorded};
  if (placed_ == cause) return Done{};
  placed_ = cause;
  const Surroundings place = surroundings_of(tuning.scene, crowd.size(), tuning.seed, roles, tuning.clothes);
  ground_ = place.ground;
  std::vector<render::SceneryInstance> instances;
  std::vector<render::SceneryLamp> lamps;
  instances.reserve(place.props.size());
  for (const PlacedProp& prop : place.props) {
    add_lamps(prop, lamps);
    const auto mesh = meshes_[static_cast<std::size_t>(prop.prop)];
    if (mesh) instances.push_back({*mesh, prop.place, prop.tint});
  }
  if (recorded != nullptr && plan_mesh_) instances.push_back({*plan_mesh_});
  renderer.place_scenery(instances);
  renderer.place_lamps(lamps);
  return Done{};
}

}  // namespace throng::app
