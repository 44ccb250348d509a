#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "throng/render/camera.h"

#include "app/settings/settings.h"
#include "app/show/stage/animated_crowd.h"
#include "app/show/stage/picking.h"
#include "app/show/stage/posed_crowd.h"

namespace throng::app {

/// A stage brings characters, the crowd of a scene and its poses together. A frame is
///     move(dt)            the crowd walks on, asks for clips, every clock advances
///     pose(...)           level of detail chooses, slots are taken, the PUs write them
/// Then Picture sorts the agents of posed().selection() into draws.
class Stage {
 public:
  /// Makes a stage for 1 to most_models people in `characters`, and adds the balloon to them. Every agent is one of
  /// these characters. Asks `pages` for no page before the first pose. Counts frames on from `first_frame`.
  /// `trajectories` may be null; then there is no scene `tracks`.
  static Result<std::unique_ptr<Stage>> create(std::vector<CharacterSource> characters, const Tuning& tuning,
                                               render::PalettePageSource& pages, std::uint64_t first_frame = 0,
                                               std::shared_ptr<const Trajectories> trajectories = {});

  /// Takes new tuning, at a frame boundary. A different crowd starts anew. Errors: those of AnimatedCrowd::configure;
  /// then the old tuning goes on.
  Status apply(const Tuning& tuning);

  /// Takes other clips for the roles of a character, and another share of the crowd where one is given, at a frame
  /// boundary. Agents keep their places, and also their phase if the clip stays. The crowd starts anew with another
  /// share, where the character begins or ceases to walk, and in a cut scene.
  void set_roles(std::size_t character, const RoleClips& clips, std::optional<double> share = {});

  /// Takes another order of a character's bones, and other levels, at a frame boundary. The character is baked anew,
  /// and the crowd goes on. Pictures need its meshes loaded again. Errors: those of check_bone_lod and
  /// anim::Characters::replace; then nothing has changed.
  Status set_bone_lod(std::size_t character, const BoneLodChoice& choice);
  /// Takes other parts of a character's body, at a frame boundary. Stances, gazes and rag-dolls are made anew of them,
  /// and the crowd starts anew. Errors: those of take_rig and AnimatedCrowd::create; then nothing has changed.
  Status set_rig(std::size_t character, const std::vector<RigChoice>& choices);
  /// Takes other rules of which agent wears what, at a frame boundary. `file` is where they come from now; empty: where
  /// they did. The crowd starts anew if it dresses, since bodies and things in hands decide what people do. Errors: the
  /// rules name a part that the character lacks; then nothing has changed.
  Status set_cast_rules(std::size_t character, CastRules rules, const std::string& file = {});
  /// Starts the crowd and every clock anew. From here on, all happens as on a stage just made.
  void restart();

  /// Takes a recorded crowd to another time, at a frame boundary. All agents are posed for it at once. While another
  /// scene is shown, the crowd waits at that time.
  void set_track_clock(const TrackClock& clock);
  /// Returns the clock of the recorded crowd; nothing where there is none, or it was never shown nor set.
  const std::optional<TrackClock>& track_clock() const { return track_clock_; }
  /// Forgets the recorded crowd, which is not shown now.
  void forget_trajectories() { trajectories_.reset(), track_clock_.reset(); }
  /// Takes the rows that came of a live crowd; they belong to its trajectories. Call it before move().
  void take_live_step(const LiveStep& step);

  void move(Ticks delta);

  /// Chooses which agents are updated, takes slots for them and poses them. `completed_frame` is the newest frame that
  /// the device has finished reading. `frame_step` is the time of one frame, for looking ahead.
  void pose(const render::Camera& camera, int width, int height, Ticks frame_step, std::uint64_t completed_frame);

  /// Selects the agent that is looked at and marked in the picture. Lets go of the held clip of another agent. The
  /// choice is forgotten when the crowd starts anew.
  void select(std::optional<std::uint32_t> agent);
  std::optional<std::uint32_t> selected() const { return selected_; }

  /// Does what AnimatedCrowd::go_back_to does, and forgets which poses are shown.
  Status go_back_to(const StageMoment& moment);

  /// Returns the poses that are shown, with level of detail and the measures of them.
  PosedCrowd& posed() { return posed_; }
  const PosedCrowd& posed() const { return posed_; }
  const anim::AnimationSystem& system() const { return animated_->system(); }
  const Crowd& crowd() const { return animated_->crowd(); }
  const AnimatedCrowd& animated() const { return *animated_; }
  /// Returns the crowd for requests that a person makes by hand.
  AnimatedCrowd& animated() { return *animated_; }
  std::span<const CharacterSource> characters() const { return characters_; }
  std::span<const CharacterSource> people() const;  ///< the characters that are no props
  const CharacterSource& character_of(std::uint32_t agent) const { return characters_[crowd().characters()[agent]]; }
  std::span<const Clothing> clothing() const { return clothing_; }  ///< [character]
  /// Returns the recorded crowd of the scene `tracks`; null where there is none.
  const std::shared_ptr<const Trajectories>& trajectories() const { return trajectories_; }
  const Tuning& tuning() const { return tuning_; }
  const StageTimes& times() const { return times_; }
  std::uint32_t now() const;  ///< microseconds modulo 2^32, the clock of InstanceRecord::blend_start

 private:
  Stage(std::vector<CharacterSource> characters, render::PalettePageSource& pages, std::uint64_t first_frame);
  void populate(AnimatedCrowd::Clocks clocks = AnimatedCrowd::Clocks::go_on);
  void jump();
  Status can_show(Tuning& tuning) const;

  std::vector<CharacterSource> characters_;
  std::vector<Clothing> clothing_;                    // [character]
  std::shared_ptr<const Trajectories> trajectories_;  // null: none
  std::optional<TrackClock> track_clock_;             // of the recorded crowd, also while another scene is shown
  Tuning tuning_;
  PosedCrowd posed_;
  std::unique_ptr<AnimatedCrowd> animated_;
  std::optional<std::uint32_t> selected_;
  StageTimes times_;
  bool moving_ = true;
};

/// Returns the cylinder around the agent, as wide as its body without the arms.
UprightBody body_of(const Stage& stage, std::uint32_t agent);
/// Returns the bodies that can be clicked at: one for each agent in view, in ascending order of agent. Allocates.
std::vector<UprightBody> bodies_in_view(const Stage& stage);

}  // namespace throng::app
