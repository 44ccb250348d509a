#include "app/show/scenery.h"

#include <algorithm>

namespace throng::app {

anim::Status Scenery::load(std::span<const render::SceneryMeshData> props, render::Renderer& renderer) {
  for (std::size_t prop = 0; prop < prop_count; ++prop) {
    const auto mesh = std::ranges::find(props, prop_names[prop], &render::SceneryMeshData::name);
    if (mesh != props.end()) meshes_[prop] = static_cast<std::uint32_t>(mesh - props.begin());
  }
  placed_.reset();
  if (auto loaded = renderer.load_scenery(props); !loaded) return anim::Error{loaded.error().message};
  return anim::Done{};
}

void Scenery::follow(const Tuning& tuning, const Crowd& crowd, render::Renderer& renderer) {
  const CharacterRoles& roles = crowd.laid_out_for();
  const Cause cause{tuning.scene,     crowd.size(),       tuning.seed,     roles.spacing(),
                    roles.walk_speed, roles.walk_seconds, roles.can_walk()};
  if (placed_ == cause) return;
  placed_ = cause;
  const Place place = place_of(tuning.scene, crowd.size(), tuning.seed, roles);
  ground_ = place.ground;
  std::vector<render::SceneryInstance> instances;
  instances.reserve(place.props.size());
  for (const PlacedProp& prop : place.props) {
    const auto mesh = meshes_[static_cast<std::size_t>(prop.prop)];
    if (mesh) instances.push_back({*mesh, prop.place, prop.tint});
  }
  renderer.place_scenery(instances);
}

}  // namespace throng::app
