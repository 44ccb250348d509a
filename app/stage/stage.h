#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/lod/error_meter.h"
#include "app/lod/exact_poses.h"
#include "app/lod/mesh_choice.h"
#include "app/lod/mesh_lods.h"
#include "app/lod/shown_poses.h"
#include "app/measure/crowd_measures.h"
#include "app/settings/settings.h"
#include "app/stage/animated_crowd.h"
#include "app/stage/kept_joints.h"
#include "app/stage/picking.h"
#include "engine/anim/lod/level_of_detail.h"
#include "engine/render/camera.h"
#include "engine/render/instance_record.h"
#include "engine/render/palette/palette_slots.h"

namespace throng::app {

/// The milliseconds that the parts of the last frame took on the calling thread.
struct StageTimes {
  double crowd_ms = 0;      ///< move(): where everybody goes, and what is played
  double selection_ms = 0;  ///< who is in view, and how exactly each is posed
  double pose_ms = 0;       ///< the rest of pose(): slots, feet, palettes, errors
};

/// A stage brings the crowd, its level of detail, its animation and its palette slots together. A frame is
///     move(dt)            the crowd walks on, asks for clips, every clock advances
///     pose(...)           level of detail chooses, slots are taken, the PUs write them
/// Then selection() and record() say what to draw.
class Stage {
 public:
  /// Makes a stage for 1 to most_models people in `characters`, and adds the balloon to them. Every agent is one of
  /// these characters. Asks `pages` for no page before the first pose. Counts frames on from `first_frame`.
  /// `trajectories` may be null; then there is no scene `tracks`.
  static anim::Result<std::unique_ptr<Stage>> create(std::vector<CharacterSource> characters, const Tuning& tuning,
                                                     render::PalettePageSource& pages, std::uint64_t first_frame = 0,
                                                     std::shared_ptr<const Trajectories> trajectories = {});

  /// Takes new tuning, at a frame boundary. A different crowd starts anew. Errors: those of AnimatedCrowd::configure;
  /// then the old tuning goes on.
  anim::Status apply(const Tuning& tuning);

  /// Takes other clips for the roles of a character, and another share of the crowd where one is given, at a frame
  /// boundary. Agents keep their places, and those whose clip stays their phase. The crowd starts anew with another
  /// share, where the character begins or ceases to walk, and in a cut scene.
  void set_roles(std::size_t character, const RoleClips& clips, std::optional<double> share = {});

  /// Takes another order of a character's bones, and other levels, at a frame boundary. The character is baked anew,
  /// and the crowd goes on. Pictures need its meshes loaded again. Errors: those of check_bone_lod and
  /// anim::Characters::replace; then nothing has changed.
  anim::Status set_bone_lod(std::size_t character, const BoneLodChoice& choice);
  /// Takes other parts of a character's body, at a frame boundary. What stands, looks and falls is made anew of them,
  /// and the crowd starts anew. Errors: those of take_rig and AnimatedCrowd::create; then nothing has changed.
  anim::Status set_rig(std::size_t character, const std::vector<RigChoice>& choices);
  /// Starts the crowd and every clock anew. From here on, all happens as on a stage just made.
  void restart();

  void move(anim::Ticks delta);

  /// Chooses which agents are updated, takes slots for them and poses them. `completed_frame` is the newest frame that
  /// the device has finished reading. `frame_step` is the time of one frame, for looking ahead.
  void pose(const render::Camera& camera, int width, int height, anim::Ticks frame_step, std::uint64_t completed_frame);

  /// Poses everybody in view once more, exactly and with all bones. These are Poses::exact; they have slots of their
  /// own until the next pose(). Changes nothing that is shown. Costs as much as everybody in view at full rate.
  void pose_exactly();

  /// Selects the agent that is looked at and marked in the picture. Lets go of the held clip of another agent. The
  /// choice is forgotten when the crowd starts anew.
  void select(std::optional<std::uint32_t> agent);
  std::optional<std::uint32_t> selected() const { return selected_; }

  /// Does what AnimatedCrowd::go_back_to does, and forgets what is shown.
  anim::Status go_back_to(const StageMoment& moment);

  /// Fills the instance record of a visible agent. Returns false if the agent has no slot; then it is not drawn.
  bool record(const anim::VisibleAgent& agent, render::InstanceRecord& record, Poses poses = Poses::shown) const;
  /// Returns the pose of an agent. Poses::exact exist only after pose_exactly(), for agents in view.
  const ShownPose& pose_of(std::uint32_t agent, Poses poses) const {
    return poses == Poses::exact ? exact_.pose(agent) : shown_.pose(agent);
  }

  const ErrorMeter& error_meter() const { return meter_; }
  MeshLods& mesh_lods() { return mesh_lods_; }
  const MeshLods& mesh_lods() const { return mesh_lods_; }

  const anim::LodSelection& selection() const { return lod_.selection(); }
  const anim::LevelOfDetail& level_of_detail() const { return lod_; }
  const ShownPoses& shown() const { return shown_; }
  const anim::AnimationSystem& system() const { return animated_->system(); }
  const Crowd& crowd() const { return animated_->crowd(); }
  const AnimatedCrowd& animated() const { return *animated_; }
  /// Returns the crowd for what a person does to it by hand.
  AnimatedCrowd& animated() { return *animated_; }
  std::span<const CharacterSource> characters() const { return characters_; }
  std::span<const CharacterSource> people() const;  ///< the characters that are no props
  const CharacterSource& character_of(std::uint32_t agent) const { return characters_[crowd().characters()[agent]]; }
  const Tuning& tuning() const { return tuning_; }
  std::uint64_t frame() const { return frame_; }
  std::uint32_t now() const;  ///< microseconds modulo 2^32, the clock of InstanceRecord::blend_start

 private:
  friend const StageTimes& times_of(const Stage& stage);
  friend void set_track_clock(Stage& stage, const TrackClock& clock);
  friend void take_live_step(Stage& stage, const LiveStep& step);
  friend const std::shared_ptr<const Trajectories>& trajectories_of(const Stage& stage);
  friend const MeshChoice& mesh_choice_of(const Stage& stage);
  friend const CrowdMeasures& measures_of(const Stage& stage) { return stage.measures_; }
  friend anim::Status keep_joints(Stage& stage);
  friend const KeptJoints& joints_of(const Stage& stage) { return stage.joints_; }
  friend std::span<const Clothing> clothing_of(const Stage& stage) { return stage.clothing_; }
  friend anim::Status set_cast_rules(Stage& stage, std::size_t character, CastRules rules, const std::string& file);
  Stage(std::vector<CharacterSource> characters, render::PalettePageSource& pages);
  void populate(AnimatedCrowd::Clocks clocks = AnimatedCrowd::Clocks::go_on);
  void forget_what_is_shown();
  void jump();
  void learn_level_of_detail();
  anim::Status can_show(Tuning& tuning) const;
  anim::LodLimits limits() const;
  std::array<glm::vec4, 6> seen_by(const render::Camera& camera, const glm::vec2& size) const;
  anim::LodRequest lod_request(const render::Camera& camera, const glm::vec2& size, anim::Ticks frame_step) const;
  void place_feet(const anim::AgentUpdate& update, bool near_by);
  void show(anim::AgentUpdate& update, std::uint64_t last_frame);
  void pose_fallen(std::uint64_t last_frame);
  void measure(const render::Camera& camera, const glm::vec2& size);

  std::vector<CharacterSource> characters_;
  std::vector<Clothing> clothing_;                    // [character]
  std::shared_ptr<const Trajectories> trajectories_;  // null: none
  std::optional<TrackClock> track_clock_;             // of the recorded crowd, also while another scene is shown
  Tuning tuning_;
  render::PaletteSlots slots_;
  ShownPoses shown_;
  ExactPoses exact_;
  ErrorMeter meter_;
  MeshLods mesh_lods_;
  MeshChoice mesh_choice_;
  anim::LevelOfDetail lod_;
  std::unique_ptr<AnimatedCrowd> animated_;
  KeptJoints joints_;
  CrowdMeasures measures_;
  std::optional<std::uint32_t> selected_;
  std::uint64_t frame_ = 0;
  StageTimes times_;
  bool moving_ = true;
};

/// Returns how long the parts of the last frame took.
inline const StageTimes& times_of(const Stage& stage) { return stage.times_; }

/// Takes a recorded crowd to another time, at a frame boundary. Everybody is posed for it at once.
void set_track_clock(Stage& stage, const TrackClock& clock);

/// Takes the rows that came of a live crowd, which are those of its trajectories. Call it before move().
void take_live_step(Stage& stage, const LiveStep& step);

/// Returns the recorded crowd of the scene `tracks`; null where there is none.
inline const std::shared_ptr<const Trajectories>& trajectories_of(const Stage& stage) { return stage.trajectories_; }

/// Returns the mesh LODs that everybody in view is drawn with, in the order of selection().visible.
inline const MeshChoice& mesh_choice_of(const Stage& stage) { return stage.mesh_choice_; }

/// Keeps the joints of everybody's poses from now on, for joints_of(stage). Errors: those of KeptJoints::begin.
anim::Status keep_joints(Stage& stage);

/// Returns who wears what among a character's agents.
inline const CastRules& cast_rules_of(const Stage& stage, std::size_t character) {
  return clothing_of(stage)[character].rules;
}

/// Takes other rules of who wears what, at a frame boundary. `file` is where they come from now; empty: where they did.
/// The crowd starts anew if it dresses, since bodies and what hands hold decide what people do. Errors: the rules name
/// a part that the character lacks; then nothing has changed.
anim::Status set_cast_rules(Stage& stage, std::size_t character, CastRules rules, const std::string& file = {});

/// Returns what level of detail reads of a character, which outlives the result: feet that are placed cost on top.
anim::LodCharacter lod_character(const CharacterSource& source);

/// Returns the cylinder around the agent, as wide as its body without the arms.
UprightBody body_of(const Stage& stage, std::uint32_t agent);
/// Returns the bodies that can be clicked at: those of agents in view, in ascending order of agent. Allocates.
std::vector<UprightBody> bodies_in_view(const Stage& stage);

}  // namespace throng::app
