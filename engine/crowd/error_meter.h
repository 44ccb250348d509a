#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "throng/view_rules.h"

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/kernel/palette/surface_error.h"
#include "engine/anim/lod/error_window.h"
#include "engine/crowd/error_history.h"
#include "engine/crowd/mesh_lods.h"
#include "engine/crowd/placed_agents.h"
#include "engine/crowd/viewed_character.h"
#include "engine/crowd/watched_agents.h"

namespace throng {

/// The rules, agents, poses, mesh LODs and view in which one frame is measured.
struct MeasuredFrame {
  const ViewRules& rules;
  const PlacedAgents& agents;
  std::span<const anim::VisibleAgent> visible;  ///< by ascending agent
  const MeshLods& mesh_lods;
  std::span<const std::uint8_t> mesh_of_visible;  ///< [place in visible]
  const ShownPoses& shown;
  glm::mat4 view{1.0F}, projection{1.0F};
  glm::vec2 size{0.0F};   ///< size of the picture, pixels
  std::uint32_t now = 0;  ///< time of the shader's clock
  std::uint64_t number = 0;
};

/// Measures the error of level of detail (engine/crowd/README.md): the largest distance on screen, over points of the
/// surface, between the vertex shader's result and the exact pose of the moment. Changes no pose.
class ErrorMeter {
 public:
  /// The share of an update's cost that the meter may take to measure some of the agents. It takes more where the share
  /// pays for less than four samples a frame, and until there are enough samples for a ninety-ninth percentile.
  static constexpr double share_of_pose_cost = 0.05;

  explicit ErrorMeter(std::span<const ViewedCharacter> characters);

  /// Takes a character whose bones are in another order. Call reset() after it.
  void set_character(std::size_t character, const ViewedCharacter& viewed);
  /// Forgets all samples, for a crowd of `agents` that starts anew.
  void reset(std::size_t agents);

  /// Chooses the agents to watch. Call it before an update, when the visible agents are known.
  void begin_frame(ErrorSampling sampling, std::span<const anim::VisibleAgent> visible, const ShownPoses& shown);
  /// Returns where the PU must write a pose that ShownPoses::show gave `slot_memory`.
  std::byte* destination(std::uint32_t agent, const ShownPose& pose, std::uint32_t entries, std::byte* slot_memory) {
    return watched_.destination(agent, pose, entries, slot_memory);
  }
  /// Hands the written poses over to their slots, and measures. Call it after the update.
  void end_frame(anim::AnimationSystem& system, const MeasuredFrame& frame);

  /// Returns the errors of poses and meshes together, over the last 60 frames, or since the rules changed. All are 0
  /// while no agent is measured.
  const anim::ErrorFigures& figures() const { return figures_; }
  /// Returns the intervals in which the percentiles of figures() lie; unbounded if no agent was measured.
  anim::ErrorIntervals intervals() const { return window_.intervals(); }
  anim::ErrorFigures since_start() const { return window_.since_start(); }
  anim::ErrorIntervals intervals_since_start() const { return window_.intervals_since_start(); }
  /// Returns the largest pop of the last frame; 0 where no agent was measured in it and in the frame before.
  float newest_pop() const { return window_.newest_pop(); }
  /// Returns figures() over the last seconds.
  const ErrorHistory& history() const { return history_; }
  /// Returns the errors of poses alone, which level of detail decides by.
  anim::ErrorFigures pose_figures() const { return pose_window_.figures(); }
  /// Returns the last measured error of an agent's pose and mesh together, in pixels; below 0 if it was not measured
  /// since reset().
  float error_of(std::uint32_t agent) const { return errors_[agent]; }

 private:
  struct MeasuredCharacter {
    anim::SurfacePoints points;
    std::vector<std::vector<std::uint16_t>> kept_entries;  // [bone level][entry]
    std::vector<anim::PackingFrame> packing;               // [entry]; empty: never packed
    std::size_t entries = 0;
    double cost = 0;  // the cost of measuring one agent, in bones evaluated
  };

  void forget_other_rules(const ViewRules& rules);
  void choose_whom_to_measure(const anim::AnimationSystem& system, const MeasuredFrame& frame);
  double affordable_bones(const anim::UpdateReport& update) const;
  void take(WatchedAgent& watched);
  /// Holds the error of a pose alone, and the error of pose and mesh together.
  struct Measured {
    anim::ErrorSample pose, picture;
  };
  void measure_chosen(anim::AnimationSystem& system, const MeasuredFrame& frame);
  Measured measure(WatchedAgent& watched, const anim::PaletteMatrix* exact, const MeasuredFrame& frame,
                   std::span<anim::PaletteMatrix> room);
  static float mesh_error(std::uint32_t agent, const MeasuredFrame& frame);

  std::vector<MeasuredCharacter> characters_;
  std::size_t most_entries_ = 0;
  ErrorSampling sampling_ = ErrorSampling::off;
  ViewRules measured_with_;  // in the frame before
  WatchedAgents watched_;
  std::vector<std::uint32_t> chosen_;  // places in watched_
  std::size_t next_place_ = 0;         // the place in watched_ that was measured last
  double credit_ = 0;                  // in bones evaluated
  std::vector<anim::ExactPose> exact_;
  anim::AlignedBytes exact_palettes_;
  std::vector<Measured> measured_;            // [place in chosen_]
  std::vector<anim::PaletteMatrix> blended_;  // a room for each job
  std::vector<float> errors_;                 // [agent]
  anim::ErrorWindow window_;                  // of poses and meshes together
  anim::ErrorWindow pose_window_;
  anim::ErrorFigures figures_;
  ErrorHistory history_;
};

}  // namespace throng
