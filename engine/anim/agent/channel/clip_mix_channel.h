#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "engine/anim/agent/in_step_players.h"

namespace throng::anim {

/// Says which clip of a mix delivers data keys that several clips share (`AgentMotion`).
enum class StepVoice : unsigned char {
  own,     ///< its data keys are its own
  leads,   ///< it keeps step with others and delivers the keys that they share, with the weight of all
  follows  ///< the leading clip delivers the keys that they share
};

/// A clip of a mix, and where it is at the clock.
struct MixedClip {
  int clip = 0;
  float weight = 1.0F;     ///< above 0; shares of the sum of all
  FineTicks position = 0;  ///< may lie outside of the clip, whole loops away
  double speed = 1.0;      ///< at which it goes on until the next set(); negative: backwards
  StepVoice voice = StepVoice::own;
};

/// Plays the looping clips that its host gives, each at its given weight and position: the pose follows from the last
/// mix and the time since. It is for motion that is a function of time, such as a recorded path, whose times a host
/// shows in any order. A clip that stays in the mix keeps its player.
class ClipMixChannel final : public Channel {
 public:
  static constexpr std::size_t most = BlendedPlayers::most;

  explicit ClipMixChannel(std::span<const MixedClip> clips) { set(clips); }

  /// Sets the mix, from the next update on: 1 to `most` clips, none twice. Another mix is a misuse and changes nothing.
  void set(std::span<const MixedClip> clips);
  std::span<const MixedClip> clips() const { return {clips_.data(), count_}; }

  const char* fault(const EntityBuilder& build) const override;
  Handle state() const override { return players_.state(); }
  bool update(const EntityBuilder& build) override;
  void visit_handles(const std::function<void(Handle&)>& visit) override { players_.visit_handles(visit); }
  void destroy_entities(const EntityBuilder& build) override { players_.destroy_entities(build); }
  std::unique_ptr<Channel> clone() const override { return std::make_unique<ClipMixChannel>(*this); }

 private:
  void place_players(const EntityBuilder& build) const;

  std::array<MixedClip, most> clips_{};
  std::size_t count_ = 0;
  BlendedPlayers players_;  // of clips_, after update()
};

}  // namespace throng::anim
