#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "throng/render/renderer.h"

#include "app/people/place/place.h"
#include "app/settings/settings.h"
#include "engine/tracks/trajectories.h"

namespace throng::app {

class Stage;

/// The place around a crowd, as the renderer draws it.
class Scenery {
 public:
  /// Gives the renderer the props of all places. Errors: those of Renderer::load_scenery.
  Status load(std::vector<render::SceneryMeshData> props, render::Renderer& renderer);

  /// Places props around the crowd of a stage, or the walls and floors of a recorded one, if another place stood there
  /// before. Errors: those of Renderer::load_scenery, which the first frame of a recorded crowd calls again.
  Status follow(const Stage& stage, render::Renderer& renderer);

  /// Returns how many lines the plan of a recorded crowd has, if they are too many to be drawn; else 0.
  std::size_t lines_left_out() const { return lines_left_out_; }

  const render::SceneGround& ground() const { return ground_; }

 private:
  /// Gives the renderer the walls and floors of a recorded crowd, if it has the ones of another crowd.
  Status load_plan_of(const Stage& stage, render::Renderer& renderer);

  /// All that a place follows from.
  struct Cause {
    Scene scene;
    std::size_t agents;
    std::uint32_t seed;
    double spacing, walk_speed, walk_seconds;
    bool walks;
    Clothes clothes;
    const Trajectories* recorded;

    friend bool operator==(const Cause&, const Cause&) = default;
  };

  std::vector<render::SceneryMeshData> loaded_;                  // props, then the plan's mesh where there is one
  std::array<std::optional<std::uint32_t>, prop_count> meshes_;  // [prop]; none: there is no such mesh
  std::shared_ptr<const Trajectories> planned_;                  // the crowd whose plan is loaded; null: none is
  std::optional<std::uint32_t> plan_mesh_;
  std::size_t lines_left_out_ = 0;
  std::optional<Cause> placed_;
  render::SceneGround ground_;
};

}  // namespace throng::app
