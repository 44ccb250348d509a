#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "app/crowd/crowd.h"
#include "app/place/place.h"
#include "app/settings/settings.h"
#include "engine/render/renderer.h"

namespace throng::app {

/// The place around a crowd, as the renderer draws it.
class Scenery {
 public:
  /// Gives the renderer the props of all places. Errors: those of Renderer::load_scenery.
  anim::Status load(std::span<const render::SceneryMeshData> props, render::Renderer& renderer);

  /// Places props around the crowd of a tuning, if another place stood there before.
  void follow(const Tuning& tuning, const Crowd& crowd, render::Renderer& renderer);

  const render::SceneGround& ground() const { return ground_; }

 private:
  /// All that a place follows from.
  struct Cause {
    Scene scene;
    std::size_t agents;
    std::uint32_t seed;
    double spacing, walk_speed, walk_seconds;
    bool walks;
    Clothes clothes;

    friend bool operator==(const Cause&, const Cause&) = default;
  };

  std::array<std::optional<std::uint32_t>, prop_count> meshes_;  // [prop]; none: there is no such mesh
  std::optional<Cause> placed_;
  render::SceneGround ground_;
};

}  // namespace throng::app
