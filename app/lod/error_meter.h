#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "app/character/source.h"
#include "app/crowd/crowd.h"
#include "app/lod/mesh_lods.h"
#include "app/lod/watched_agents.h"
#include "app/settings/settings.h"
#include "engine/anim/agent/animation_system.h"
#include "engine/anim/kernel/palette/surface_error.h"
#include "engine/anim/lod/error_window.h"
#include "engine/render/camera.h"

namespace throng::app {

/// A frame whose errors are measured.
struct MeasuredFrame {
  const Tuning& tuning;
  const Crowd& crowd;
  std::span<const anim::VisibleAgent> visible;  ///< by ascending agent
  const MeshLods& mesh_lods;
  const ShownPoses& shown;
  render::CameraView view;
  glm::vec2 size{0.0F};   ///< of the picture, pixels
  std::uint32_t now = 0;  ///< of the shader's clock
  std::uint64_t number = 0;
};

/// Measures what level of detail costs the eye (app/lod/README.md): the largest distance on
/// screen, over points of the surface, between what the vertex shader shows and the exact pose of the moment. Changes
/// no pose.
class ErrorMeter {
 public:
  /// Measured in every frame of which the meter may take its share of the update.
  static constexpr double share_of_pose_cost = 0.05;

  explicit ErrorMeter(std::span<const CharacterSource> characters);

  /// The same character with its bones in another order; a reset follows.
  void set_character(std::size_t character, const CharacterSource& source);
  /// A crowd starts anew.
  void reset(std::size_t agents);

  /// Before an update, whenever the crowd has decided who is visible.
  void begin_frame(ErrorSampling sampling, std::span<const anim::VisibleAgent> visible, const ShownPoses& shown);
  /// Where the PU writes a pose that ShownPoses::show gave `slot_memory`.
  anim::PaletteDestination destination(std::uint32_t agent, const ShownPose& pose, std::uint32_t entries,
                                       anim::PaletteDestination slot_memory) {
    return watched_.destination(agent, pose, entries, slot_memory);
  }
  /// After the update.
  void end_frame(anim::AnimationSystem& system, const MeasuredFrame& frame);

  /// Returns the errors of poses and meshes together, over the last 60 frames. All are 0 while nobody is measured.
  const anim::ErrorFigures& figures() const { return figures_; }
  anim::ErrorFigures since_start() const { return window_.since_start(); }
  /// Returns the errors of poses alone, which level of detail decides by.
  anim::ErrorFigures pose_figures() const { return pose_window_.figures(); }
  /// Returns pixels, of pose and mesh together, as measured last; below 0: not since the agent came into view.
  float error_of(std::uint32_t agent) const { return errors_[agent]; }
  const anim::SurfacePoints& points(std::size_t character) const { return characters_[character].points; }

 private:
  struct MeasuredCharacter {
    anim::SurfacePoints points;
    std::vector<std::vector<std::uint16_t>> kept_entries;  // [bone level][entry]
    std::vector<anim::PackingFrame> packing;               // [entry]; empty: never packed
    std::size_t entries = 0;
    double cost = 0;  // of measuring one agent, in bones evaluated
  };

  void choose_whom_to_measure(const anim::AnimationSystem& system, const MeasuredFrame& frame);
  void take(WatchedAgent& watched);
  void measure(WatchedAgent& watched, const anim::PaletteMatrix* exact, const MeasuredFrame& frame);
  static float mesh_error(std::uint32_t agent, const MeasuredFrame& frame);

  std::vector<MeasuredCharacter> characters_;
  std::size_t most_entries_ = 0;
  ErrorSampling sampling_ = ErrorSampling::off;
  WatchedAgents watched_;
  std::vector<std::uint32_t> chosen_;  // places in watched_
  std::size_t next_place_ = 0;         // whose turn it is, of those watched
  double credit_ = 0;                  // in bones evaluated
  std::vector<anim::ExactPose> exact_;
  anim::AlignedBytes exact_palettes_;
  std::vector<anim::PaletteMatrix> blended_;
  std::vector<float> errors_;  // [agent]
  anim::ErrorWindow window_;   // of poses and meshes together
  anim::ErrorWindow pose_window_;
  anim::ErrorFigures figures_;
};

}  // namespace throng::app
