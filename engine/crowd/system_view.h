#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "throng/view_rules.h"

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/lod/level_of_detail.h"
#include "engine/crowd/error_meter.h"
#include "engine/crowd/exact_poses.h"
#include "engine/crowd/mesh_choice.h"
#include "engine/crowd/mesh_lods.h"
#include "engine/crowd/palette_slots.h"
#include "engine/crowd/placed_agents.h"
#include "engine/crowd/shown_poses.h"
#include "engine/crowd/viewed_character.h"

namespace throng {

/// How a crowd is seen in a frame. The spans have one element an agent.
struct SystemFrame {
  PlacedAgents agents;
  std::span<const int> clips = {};              ///< anim::LodCrowd::clips
  std::span<const std::uint8_t> left_out = {};  ///< anim::LodCrowd::left_out
  std::span<const std::uint8_t> absent = {};    ///< anim::LodCrowd::absent
  ViewRules rules;
  ErrorSampling sampling = ErrorSampling::some;
  Camera camera;  ///< its frustum may be wider than the picture, for agents that cast shadows into it
  glm::mat4 view{1.0F}, projection{1.0F};      ///< of the picture
  glm::vec2 size{0.0F};                        ///< of the picture, pixels
  Ticks step{};                                ///< the time of a frame, for looking ahead; 0: time stands still
  std::optional<std::uint32_t> selected = {};  ///< an agent that shows a quarter of the others' error
  std::uint64_t completed = 0;                 ///< the newest frame that the device has finished reading
};

/// Shows a crowd: level of detail chooses the agents that are posed, slots take their palettes, skipped poses are
/// blended on the screen, and the error of what is shown is measured. One thread calls it. In a frame:
///
///     choose(system, frame)            lists updates()
///     show(system, frame, update)      for each update of a visible agent: the slot of its palette
///     pose(system, frame)              the PUs write the palettes
class SystemView {
 public:
  /// Asks `pages`, which outlive the view, for no page before the first pose. Counts frames on from `first_frame`.
  /// `more_sizes` lists bytes of palettes that characters may have later.
  SystemView(std::vector<ViewedCharacter> characters, render::PalettePageSource& pages, std::uint64_t first_frame = 0,
             std::span<const std::size_t> more_sizes = {});

  /// Begins figures and turns anew, as if just made; call reset() after it.
  void restart();
  /// Forgets all agents, for a crowd of `agents` that was made anew.
  void reset(std::size_t agents, const LodRules& rules);
  /// Forgets what is shown: no agent blends from a pose of before, and all are posed at once.
  void forget_shown(std::size_t agents, const LodRules& rules);
  /// Takes a character whose bones are in another order, or that has other levels; all its agents are posed at once.
  void take_character(std::size_t character, const ViewedCharacter& viewed);

  /// Takes other characters, none of which has a larger palette than was announced. Forgets all that is known of those
  /// before; call reset() after it.
  void set_characters(std::vector<ViewedCharacter> characters);

  /// Finds the agents in view and their meshes, and lists the agents to be posed.
  void choose(anim::AnimationSystem& system, const SystemFrame& frame);
  /// Returns the list for pose(). The host may set PoseRequest::joints.
  std::span<PoseRequest> updates() { return lod_.updates(); }
  std::span<const PoseRequest> updates() const { return lod_.updates(); }
  /// Asks the caches for the pose of an agent, for which show() is called soon.
  void prefetch_pose(std::uint32_t agent) const { shown_.prefetch_pose(agent); }
  /// Takes a slot for the pose of a visible agent. Returns whether the update, which looked ahead, must be of now
  /// instead: there is nothing on the new page that it could be blended from.
  bool show(const anim::AnimationSystem& system, const SystemFrame& frame, PoseRequest& update);
  /// Poses an agent of SystemFrame::left_out too, for the moment. Returns its update.
  PoseRequest& show_also(const anim::AnimationSystem& system, const SystemFrame& frame, std::uint32_t agent);
  /// Poses the listed agents, measures errors and settles level of detail.
  void pose(anim::AnimationSystem& system, const SystemFrame& frame);

  /// Poses all agents in view with all bones for the same moment. These are Poses::exact; they have slots of their own
  /// until the next choose(). Changes nothing that is shown. Costs as much as all agents in view at full rate.
  void pose_exactly(anim::AnimationSystem& system, const PlacedAgents& agents);

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
  std::span<const ViewedCharacter> characters() const { return characters_; }
  std::uint64_t frame() const { return frame_; }
  /// Returns the shader's time of the frame that was chosen last.
  std::uint32_t now() const { return now_; }

 private:
  void learn_level_of_detail();
  void measure(anim::AnimationSystem& system, const SystemFrame& frame);
  void settle(const anim::AnimationSystem& system);

  std::vector<ViewedCharacter> characters_;
  PaletteSlots slots_;
  ShownPoses shown_;
  ExactPoses exact_;
  ErrorMeter meter_;
  MeshLods mesh_lods_;
  MeshChoice mesh_choice_;
  anim::LevelOfDetail lod_;
  std::size_t agents_ = 0;
  std::uint64_t frame_;
  std::uint32_t now_ = 0;
};

/// Returns the time of a clock as InstanceRecord::blend_start has it: microseconds modulo 2^32.
std::uint32_t shader_time(Ticks clock);

/// Returns a character as level of detail reads it. `viewed` outlives it.
anim::LodCharacter lod_character(const ViewedCharacter& viewed);

}  // namespace throng
