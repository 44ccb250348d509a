#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "app/character/source.h"
#include "app/people/crowd/crowd.h"
#include "app/people/wardrobe/clothing.h"
#include "app/settings/settings.h"
#include "app/show/stage/body_details.h"
#include "app/show/stage/cut_scene.h"
#include "app/show/stage/event_sums.h"
#include "app/show/stage/fallen_agents.h"
#include "engine/anim/agent/animation_system.h"
#include "engine/anim/agent/character_rigs.h"
#include "engine/anim/lod/level_of_detail.h"
#include "engine/base/gathered.h"

namespace throng::app {

struct StageMoment;

/// A crowd and the animation system that it plays in: agents of the system play what the crowd asks for, and what a
/// person asks for by hand. It tells level of detail when an agent changes clip.
class AnimatedCrowd {
 public:
  /// Makes a crowd without agents; populate() adds them. `characters` and `lod` outlive the crowd. Errors: those of
  /// AnimationSystem::create and Characters::add.
  static Result<std::unique_ptr<AnimatedCrowd>> create(std::span<const CharacterSource> characters,
                                                       const anim::SystemOptions& options, anim::LevelOfDetail& lod);

  /// Changes the options of the system, at a frame boundary. Errors: those of AnimationSystem::configure; then the old
  /// options go on.
  Status configure(const anim::SystemOptions& options);
  /// Does what Characters::replace does. Errors: its own.
  Status reorder_bones(std::size_t character, std::shared_ptr<const anim::Character> reordered,
                       std::span<const int> places);

  enum class Clocks : std::uint8_t { go_on, begin_anew };
  /// Makes the crowd of the tuning's scene anew. The scene `tracks` needs its people. `clothing` has one element a
  /// character; agents are dressed as its rules say where the tuning asks for it.
  void populate(const Tuning& tuning, Clocks clocks, std::span<const Clothing> clothing,
                const TrackSource& tracks = {});
  /// Gives each agent the thing that its hands hold, [agent]; empty: nothing. Agents are as they were made.
  void give(std::vector<HeldThing> things);

  /// Lets all agents go on where they are, by the clips that the roles of the characters have now. Each character can
  /// walk as before.
  void take_roles();

  /// Advances every clock; the crowd walks on and asks for clips.
  void move(Ticks delta);
  /// Returns the parts that pose agents beyond these clips.
  BodyDetails& details() { return *details_; }
  const BodyDetails& details() const { return *details_; }
  /// Lets agents that lay long enough stand up and go on. Call it after an update.
  void let_fallen_get_up();

  /// Pushes an agent over, in the world's `direction` (its height is ignored). Errors: the agent acts in the cut scene,
  /// its character has nothing that could fall, or the local store has no room for it.
  Status push_over(std::uint32_t agent, const glm::vec3& direction);
  bool can_fall(std::uint32_t agent) const;
  const FallenAgents& fallen() const { return *fallen_; }

  struct HeldClip {
    std::uint32_t agent = 0;
    int clip = no_clip;
    float seconds = 0;
  };
  /// Holds an agent where it is, and the clip that it plays at `seconds` of it. Does nothing to an agent that acts in
  /// the cut scene or has fallen.
  void hold_clip(std::uint32_t agent, float seconds);
  void let_go_of_clip();
  const std::optional<HeldClip>& held_clip() const { return held_clip_; }
  /// Returns the length of the clip that the agent plays or is held in; 0 if it plays none.
  float clip_seconds(std::uint32_t agent) const;

  /// Stores all that changes as time passes.
  void remember(StageMoment& into) const;
  /// Puts back what remember() stored; the crowd then goes on to the same poses. Errors: the moment is of another crowd
  /// or schedule; then nothing has changed.
  Status go_back_to(const StageMoment& moment);
  /// Returns a number that differs for each crowd that was made, and after bones changed their order.
  std::uint64_t number() const { return number_; }
  /// Returns the time since this crowd was placed; the clock of the system goes on from crowd to crowd.
  Ticks age() const { return system_->clock() - began_at_; }

  /// Sums up the data keys and places of all agents from now on. This takes about as long as the crowd's own logic.
  void sum_up_events() { event_sums_.emplace().reset(crowd_->size()); }
  const std::optional<EventSums>& event_sums() const { return event_sums_; }

  /// Returns the rigs with which a character stands, looks and falls.
  const anim::CharacterRigs& rigs(std::size_t character) const { return *rigs_[character]; }

  /// Returns [agent] the hash of its last pose, also of the film's camera. Hashes of agents that left are left out;
  /// they stand at the end, since the agents that are there have the first numbers.
  std::span<const std::uint64_t> agent_hashes() const {
    const std::span<const std::uint64_t> all = system_->figures().agent_hashes();
    return all.first(std::min<std::size_t>(all.size(), system_->agent_count()));
  }

  anim::AnimationSystem& system() { return *system_; }
  const anim::AnimationSystem& system() const { return *system_; }
  Crowd& crowd() { return *crowd_; }
  const Crowd& crowd() const { return *crowd_; }
  /// Returns the camera of the cut scene; null in the other scenes.
  const CutScene* cut_scene() const { return cut_scene_.get(); }

 private:
  AnimatedCrowd(std::span<const CharacterSource> characters, anim::LevelOfDetail& lod)
      : characters_(characters), lod_(&lod) {}
  Status open(const anim::SystemOptions& options);
  const CharacterSource& character_of(std::uint32_t agent) const { return characters_[crowd_->characters()[agent]]; }
  bool follows_a_script(std::uint32_t agent) const {
    return crowd_->minds().habits()[agent] == Habit::act || crowd_->minds().habits()[agent] == Habit::follow;
  }
  bool holds_clip(std::uint32_t agent) const { return held_clip_ && held_clip_->agent == agent; }
  void play(std::uint32_t agent, int clip, Ticks fade, double start_phase);
  void change_clip(std::uint32_t agent, int clip, Ticks fade, double start_phase = 0.0);
  void change_clip(const std::optional<ClipRequest>& request);
  void match_playback();
  void dress(std::span<const Clothing> clothing, const Tuning& tuning);

  std::span<const CharacterSource> characters_;
  anim::LevelOfDetail* lod_;
  std::vector<std::unique_ptr<anim::CharacterRigs>> rigs_;  // [character]
  std::uint32_t film_camera_ = 0;                           // the system's number of the cut scene's camera
  std::unique_ptr<anim::AnimationSystem> system_;
  std::unique_ptr<FallenAgents> fallen_;
  std::unique_ptr<BodyDetails> details_;
  std::optional<EventSums> event_sums_;
  std::unique_ptr<Crowd> crowd_;
  std::unique_ptr<CutScene> cut_scene_;  // null in the other scenes
  std::vector<float> played_speeds_;     // of each agent's clip, as the system was told
  Gathered<SpeedRequest> new_speeds_;    // of this frame
  std::optional<HeldClip> held_clip_;
  std::uint64_t number_ = 0;
  Ticks began_at_{};
};

std::vector<CharacterRoles> roles_of(std::span<const CharacterSource> characters);

/// Returns the options with as many PUs as the machine has cores, where their number is 0.
anim::SystemOptions on_this_machine(anim::SystemOptions options);

}  // namespace throng::app
