#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "app/character/source.h"
#include "app/crowd/crowd.h"
#include "app/lod/bone_step.h"
#include "app/lod/crowd_lod.h"
#include "app/lod/error_meter.h"
#include "app/lod/exact_poses.h"
#include "app/lod/shown_poses.h"
#include "app/settings/settings.h"
#include "app/stage/cut_scene.h"
#include "app/stage/event_sums.h"
#include "app/stage/fallen_agents.h"
#include "app/stage/picking.h"
#include "app/stage/placed_feet.h"
#include "engine/anim/agent/animation_system.h"
#include "engine/anim/agent/character_rigs.h"
#include "engine/anim/lod/lod.h"
#include "engine/anim/run/pu_threads.h"
#include "engine/render/camera.h"
#include "engine/render/instance_record.h"
#include "engine/render/palette/palette_slots.h"

namespace throng::app {

struct StageMoment;

/// Where the crowd, its level of detail, its animation and its palette slots meet. A frame is
///     move(dt)            the crowd walks on, asks for clips, every clock advances
///     pose(...)           level of detail chooses, slots are taken, the PUs write them
/// after which selection() and records() say what to draw.
class Stage {
 public:
  /// `characters`: 1 to most_models people, then props; every agent is one of them. Asks
  /// `pages` for none before the first pose. `first_frame`: frames are counted on from it.
  static anim::Result<std::unique_ptr<Stage>> create(std::vector<CharacterSource> characters, const Tuning& tuning,
                                                     render::PalettePageSource& pages, std::uint64_t first_frame = 0);

  /// New tuning, at a frame boundary. A different crowd starts anew; on error the old tuning goes on.
  anim::Status apply(const Tuning& tuning);

  /// Other clips for the roles of a character, at a frame boundary; the crowd starts anew.
  void set_roles(std::size_t character, const RoleClips& clips);

  /// Another order of a character's bones, and other levels, at a frame boundary: it is baked anew, the crowd goes on.
  /// Pictures want its meshes loaded again. Errors, and then nothing has changed: as check_bone_lod and
  /// anim::Characters::replace.
  anim::Status set_bone_lod(std::size_t character, const BoneLodChoice& choice);
  /// The crowd and every clock begin anew: from here on, all happens as on a stage just made.
  void restart();

  void move(anim::Ticks delta);

  /// From now on everybody's data keys and places are summed up: takes about as long as the crowd's own logic.
  void sum_up_events();
  const std::optional<EventSums>& event_sums() const { return event_sums_; }

  /// `completed_frame` is the newest that the device has finished reading; `frame_step` what one frame takes, for
  /// looking ahead.
  void pose(const render::Camera& camera, int width, int height, anim::Ticks frame_step, std::uint64_t completed_frame);

  /// Poses everybody in view once more, exactly and with all bones, into slots of their own until the next pose(): what
  /// Poses::exact are. Changes nothing that is shown; costs as much as everybody in view at full rate.
  void pose_exactly();

  /// The agent that is looked at, marked in the picture; it is forgotten when the crowd starts anew.
  void select(std::optional<std::uint32_t> agent);
  std::optional<std::uint32_t> selected() const { return selected_; }

  /// Pushes an agent over, in the world's `direction` (the height of it is ignored). Errors: there is nothing in its
  /// character that could fall, or no room for it in the local store.
  anim::Status push_over(std::uint32_t agent, const glm::vec3& direction);
  bool can_fall(std::uint32_t agent) const;
  const FallenAgents& fallen() const { return *fallen_; }

  /// Holds the clip that an agent plays at `seconds` of it, and the agent where it is; nothing happens to one who acts
  /// or has fallen. Selecting another one lets it go.
  void hold_clip(std::uint32_t agent, float seconds);
  void let_go_of_clip();
  struct HeldClip {
    std::uint32_t agent = 0;
    int clip = no_clip;
    float seconds = 0;
  };
  const std::optional<HeldClip>& held_clip() const { return held_clip_; }
  /// Of the clip that the agent plays, or is held in; 0 if it plays none.
  float clip_seconds(std::uint32_t agent) const;

  /// Keeps all that changes as time passes; and puts it back, after which the crowd goes on to the same poses. Errors:
  /// the moment is of another crowd or schedule; then nothing has changed.
  void remember(StageMoment& into) const;
  anim::Status go_back_to(const StageMoment& moment);
  /// Another one for each crowd that started anew, or whose bones changed their order.
  std::uint64_t crowd_number() const { return crowd_number_; }

  /// What can be clicked at: those in view, in ascending order of agent; allocates.
  std::vector<UprightBody> bodies_in_view() const;

  /// Instance record of a visible agent; false: it has no slot and is not drawn.
  bool record(const anim::VisibleAgent& agent, render::InstanceRecord& record, Poses poses = Poses::shown) const;
  /// Exact ones only after pose_exactly(), of those in view.
  const ShownPose& pose_of(std::uint32_t agent, Poses poses) const {
    return poses == Poses::exact ? exact_.pose(agent) : shown_.pose(agent);
  }

  /// What level of detail costs the eye, over the last 60 frames; all 0 while nobody is measured.
  const anim::ErrorFigures& error() const { return meter_.figures(); }
  const ErrorMeter& error_meter() const { return meter_; }

  /// How the agent's bones stood between two levels in its last update.
  const BoneStep& bone_step(std::uint32_t agent) const { return bone_steps_[agent]; }
  const anim::LodSelection& selection() const { return selection_; }
  /// What level of detail decided, and what it saves.
  const CrowdLod& level_of_detail() const { return crowd_lod_; }
  const ShownPoses& shown() const { return shown_; }
  const anim::AnimationSystem& system() const { return *system_; }
  const Crowd& crowd() const { return *crowd_; }
  /// What the scene is laid out for.
  CharacterRoles common_roles() const;
  std::span<const CharacterSource> characters() const { return characters_; }
  std::span<const CharacterSource> people() const;  ///< those that are no props
  const CharacterSource& character_of(std::uint32_t agent) const { return characters_[crowd_->characters()[agent]]; }
  const Tuning& tuning() const { return tuning_; }
  /// The camera of the cut scene; null in the other scenes.
  const CutScene* cut_scene() const { return cut_scene_.get(); }
  std::uint64_t frame() const { return frame_; }
  std::uint32_t now() const;  ///< microseconds modulo 2^32, the clock of InstanceRecord::blend_start

 private:
  Stage(std::vector<CharacterSource> characters, render::PalettePageSource& pages);
  anim::Status open_system();
  enum class Clocks : std::uint8_t { go_on, begin_anew };
  void populate(Clocks clocks = Clocks::go_on);
  void learn_level_of_detail();
  void match_playback();
  void place_feet(const anim::DueAgent& due, bool near_by);
  BoneStep step_bones(const anim::DueAgent& due);
  void pose_fallen(std::uint64_t last_frame);
  void get_up();
  bool holds_clip(std::uint32_t agent) const { return held_clip_ && held_clip_->agent == agent; }
  void request_clip(std::uint32_t agent, int clip, anim::Ticks fade, double start_phase);
  void request_clip(const std::optional<ClipRequest>& request);
  UprightBody body_of(std::uint32_t agent) const;
  anim::LodForce lod_force(const LodInspection& inspection) const;
  void measure(const render::Camera& camera, int width, int height);
  anim::LodFrame lod_frame(const render::Camera& camera, int width, int height);
  anim::PaletteDestination show(std::uint32_t agent, std::uint8_t level, std::uint32_t pose_time,
                                std::uint64_t last_frame);

  std::vector<CharacterSource> characters_;
  std::vector<std::vector<std::uint32_t>> palette_entries_;  // [character][bone level]
  std::vector<anim::LodCharacter> lod_characters_;
  Tuning tuning_;
  render::PaletteSlots slots_;
  ShownPoses shown_;
  ExactPoses exact_;
  ErrorMeter meter_;
  std::vector<std::unique_ptr<anim::CharacterRigs>> rigs_;  // [character]
  std::uint32_t film_camera_ = 0;                           // the system's number of the cut scene's camera
  std::unique_ptr<anim::AnimationSystem> system_;
  std::unique_ptr<FallenAgents> fallen_;
  std::unique_ptr<PlacedFeet> feet_;
  std::optional<EventSums> event_sums_;
  std::unique_ptr<Crowd> crowd_;
  std::unique_ptr<CutScene> cut_scene_;  // null in the other scenes
  std::vector<float> played_speeds_;     // of each agent's clip, as the system was told
  anim::LodState lod_;
  CrowdLod crowd_lod_;
  anim::LodSelection selection_;
  std::vector<BoneStep> bone_steps_;  // of each agent's last update
  std::vector<anim::AgentUpdate> updates_;
  std::optional<std::uint32_t> selected_;
  std::optional<HeldClip> held_clip_;
  std::uint64_t crowd_number_ = 0;
  std::uint64_t frame_ = 0;
  std::uint64_t frames_moved_ = 0;  // those in which time passed
  bool moving_ = true;
};

/// The same with as many PUs as the machine has cores, where their number is 0.
anim::SystemOptions on_this_machine(anim::SystemOptions options);

}  // namespace throng::app
