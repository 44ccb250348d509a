#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include <glm/vec2.hpp>

#include "app/people/measure/crowd_measures.h"
#include "app/settings/settings.h"
#include "app/show/lod/error_meter.h"
#include "app/show/lod/exact_poses.h"
#include "app/show/lod/mesh_choice.h"
#include "app/show/lod/mesh_lods.h"
#include "app/show/lod/shown_poses.h"
#include "app/show/stage/animated_crowd.h"
#include "app/show/stage/kept_joints.h"
#include "app/show/stage/stage_times.h"
#include "engine/anim/lod/level_of_detail.h"
#include "engine/render/camera.h"
#include "engine/render/palette/palette_slots.h"

namespace throng::app {

/// Tells the milliseconds since the last question, or since it was made.
class StopWatch {
 public:
  double lap() {
    const auto before = std::exchange(since_, std::chrono::steady_clock::now());
    return std::chrono::duration<double, std::milli>(since_ - before).count();
  }

 private:
  std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
};

/// How a frame is seen.
struct SeenFrame {
  render::Camera camera;
  glm::vec2 size{0.0F};                   ///< of the picture, pixels
  Ticks step{};                           ///< time of one frame, for looking ahead
  bool moves = true;                      ///< time passes
  std::optional<std::uint32_t> selected;  ///< the agent that is looked at
  std::uint64_t completed = 0;            ///< the newest frame that the device has finished reading
};

/// Poses the agents of a crowd that are seen: level of detail chooses them, slots take their palettes, and their
/// shown poses are measured.
class PosedCrowd {
 public:
  /// Asks `pages` for no page before the first pose. Counts frames on from `first_frame`. `characters` outlive this.
  PosedCrowd(std::span<const CharacterSource> characters, render::PalettePageSource& pages, std::uint64_t first_frame);

  /// Begins figures and turns anew, as if just made; call reset() after it.
  void restart();
  /// Forgets all agents, for a crowd of `agents` that was made anew.
  void reset(std::size_t agents, const Tuning& tuning);
  /// Forgets which poses of agents are shown, so that all are posed at once.
  void forget_shown(std::size_t agents, const Tuning& tuning);
  /// Takes a character whose bones have another order, and poses all agents anew.
  void take_character(std::size_t character, std::size_t agents);

  /// Poses a frame, step by step. `times` gets the milliseconds of its parts.
  void pose(AnimatedCrowd& animated, const SeenFrame& seen, const Tuning& tuning, StageTimes& times);
  /// Poses all agents in view once more, exactly and with all bones. These are Poses::exact; they have slots of their
  /// own until the next pose(). Changes nothing that is shown. Costs as much as all agents in view at full rate.
  void pose_exactly(AnimatedCrowd& animated);

  /// Keeps the joints of all poses from now on, for joints(). Errors: those of KeptJoints::begin.
  Status keep_joints(anim::AnimationSystem& system) { return joints_.begin(system, characters_); }
  const KeptJoints& joints() const { return joints_; }

  anim::LevelOfDetail& level_of_detail() { return lod_; }
  const anim::LevelOfDetail& level_of_detail() const { return lod_; }
  const anim::LodSelection& selection() const { return lod_.selection(); }
  const ShownPoses& shown() const { return shown_; }
  /// Returns the pose of an agent. Poses::exact exist only after pose_exactly(), for agents in view.
  const ShownPose& pose_of(std::uint32_t agent, Poses poses) const {
    return poses == Poses::exact ? exact_.pose(agent) : shown_.pose(agent);
  }
  MeshLods& mesh_lods() { return mesh_lods_; }
  const MeshLods& mesh_lods() const { return mesh_lods_; }
  /// Returns the mesh LODs that agents in view are drawn with, in the order of selection().visible.
  const MeshChoice& mesh_choice() const { return mesh_choice_; }
  const ErrorMeter& error_meter() const { return meter_; }
  const CrowdMeasures& measures() const { return measures_; }
  std::uint64_t frame() const { return frame_; }

 private:
  struct Frame;

  void learn_level_of_detail();
  void choose(const Frame& frame);
  std::array<glm::vec4, 6> seen_by(const Frame& frame) const;
  anim::LodRequest lod_request(const Frame& frame) const;
  void prepare(const Frame& frame, std::span<anim::AgentUpdate> updates);
  void place_feet(const Frame& frame, const anim::AgentUpdate& update, bool near_by) const;
  void show(const Frame& frame, anim::AgentUpdate& update);
  void add_fallen(const Frame& frame);
  void measure(const Frame& frame);
  void settle(const Frame& frame);

  std::span<const CharacterSource> characters_;
  render::PaletteSlots slots_;
  ShownPoses shown_;
  ExactPoses exact_;
  ErrorMeter meter_;
  MeshLods mesh_lods_;
  MeshChoice mesh_choice_;
  anim::LevelOfDetail lod_;
  KeptJoints joints_;
  CrowdMeasures measures_;
  std::uint64_t frame_;
};

/// Returns the time of a clock as InstanceRecord::blend_start has it: microseconds modulo 2^32.
std::uint32_t shader_time(Ticks clock);

/// Returns the character for level of detail, which `source` outlives: feet that are placed cost on top.
anim::LodCharacter lod_character(const CharacterSource& source);

}  // namespace throng::app
