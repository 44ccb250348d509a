#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "app/lod/error_meter.h"
#include "app/lod/exact_poses.h"
#include "app/lod/mesh_lods.h"
#include "app/lod/shown_poses.h"
#include "app/settings/settings.h"
#include "app/stage/animated_crowd.h"
#include "engine/anim/lod/level_of_detail.h"
#include "engine/render/camera.h"
#include "engine/render/instance_record.h"
#include "engine/render/palette/palette_slots.h"

namespace throng::app {

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

  /// `completed_frame` is the newest that the device has finished reading; `frame_step` what one frame takes, for
  /// looking ahead.
  void pose(const render::Camera& camera, int width, int height, anim::Ticks frame_step, std::uint64_t completed_frame);

  /// Poses everybody in view once more, exactly and with all bones, into slots of their own until the next pose(): what
  /// Poses::exact are. Changes nothing that is shown; costs as much as everybody in view at full rate.
  void pose_exactly();

  /// The agent that is looked at, marked in the picture; it is forgotten when the crowd starts anew.
  void select(std::optional<std::uint32_t> agent);
  std::optional<std::uint32_t> selected() const { return selected_; }

  /// As AnimatedCrowd::go_back_to.
  anim::Status go_back_to(const StageMoment& moment);

  /// What can be clicked at: those in view, in ascending order of agent; allocates.
  std::vector<UprightBody> bodies_in_view() const;

  /// Instance record of a visible agent; false: it has no slot and is not drawn.
  bool record(const anim::VisibleAgent& agent, render::InstanceRecord& record, Poses poses = Poses::shown) const;
  /// Exact ones only after pose_exactly(), of those in view.
  const ShownPose& pose_of(std::uint32_t agent, Poses poses) const {
    return poses == Poses::exact ? exact_.pose(agent) : shown_.pose(agent);
  }

  const ErrorMeter& error_meter() const { return meter_; }
  /// Returns the mesh LOD that a visible agent is drawn with.
  int mesh_lod(const anim::VisibleAgent& agent) const {
    return mesh_lods_.choose(tuning_, crowd().characters()[agent.agent], agent.pixels_tall);
  }
  MeshLods& mesh_lods() { return mesh_lods_; }

  const anim::LodSelection& selection() const { return lod_.selection(); }
  const anim::LevelOfDetail& level_of_detail() const { return lod_; }
  const ShownPoses& shown() const { return shown_; }
  const anim::AnimationSystem& system() const { return animated_->system(); }
  const Crowd& crowd() const { return animated_->crowd(); }
  const AnimatedCrowd& animated() const { return *animated_; }
  /// For what a person does by hand.
  AnimatedCrowd& animated() { return *animated_; }
  /// What the scene is laid out for.
  CharacterRoles common_roles() const;
  std::span<const CharacterSource> characters() const { return characters_; }
  std::span<const CharacterSource> people() const;  ///< those that are no props
  const CharacterSource& character_of(std::uint32_t agent) const { return characters_[crowd().characters()[agent]]; }
  const Tuning& tuning() const { return tuning_; }
  std::uint64_t frame() const { return frame_; }
  std::uint32_t now() const;  ///< microseconds modulo 2^32, the clock of InstanceRecord::blend_start

 private:
  Stage(std::vector<CharacterSource> characters, render::PalettePageSource& pages);
  void populate(AnimatedCrowd::Clocks clocks = AnimatedCrowd::Clocks::go_on);
  void forget_what_is_shown();
  void learn_level_of_detail();
  anim::LodLimits limits() const;
  anim::LodRequest lod_request(const render::Camera& camera, const glm::vec2& size, anim::Ticks frame_step) const;
  void place_feet(const anim::AgentUpdate& update, bool visible);
  void show(anim::AgentUpdate& update, std::uint64_t last_frame);
  void pose_fallen(std::uint64_t last_frame);
  void measure(const render::Camera& camera, const glm::vec2& size);

  std::vector<CharacterSource> characters_;
  Tuning tuning_;
  render::PaletteSlots slots_;
  ShownPoses shown_;
  ExactPoses exact_;
  ErrorMeter meter_;
  MeshLods mesh_lods_;
  anim::LevelOfDetail lod_;
  std::unique_ptr<AnimatedCrowd> animated_;
  std::optional<std::uint32_t> selected_;
  std::uint64_t frame_ = 0;
  bool moving_ = true;
};

}  // namespace throng::app
