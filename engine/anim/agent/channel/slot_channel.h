#pragma once

#include <array>
#include <cstddef>

#include "engine/anim/agent/channel/one_shot_tree.h"

namespace throng::anim {

/// "Play this clip once, over what plays."
struct OneShot {
  int clip = 0;         ///< index into the character's clips
  Ticks fade_in{};      ///< eases in from what is shown; 0 replaces it at once
  Ticks fade_out{};     ///< eases out so that the end of the clip is the end of the fade
  double speed = 1.0;   ///< multiple of the clip's own speed, not 0; negative: backwards, from the clip's end
  bool queued = false;  ///< it waits for the shots before it, and eases in over the last of them
};

/// Plays one-shots over the channels before it, and plays nothing in between: then only the channels before it are
/// seen, and it costs nothing. Over nothing, a shot neither fades in nor out.
///
/// A shot fades out before its end by itself. A shot that interrupts neither snaps nor waits: an inertialiser leaves
/// the shown pose behind. A request fixes all later changes, so poses do not depend on when an agent is posed.
class SlotChannel final : public Channel {
 public:
  /// Asks for a shot; call it through `Agent::change`. Returns false if max_shots are playing and waiting already.
  /// A shot that the character cannot play is a misuse, which the next update reports and ignores.
  bool play(const OneShot& shot);
  /// Returns whether the last update took all requests.
  bool took_all() const { return took_all_; }
  /// Ends all shots, playing and waiting, at once.
  void stop();

  /// Returns whether a shot plays or waits at a time of the clock, from now on.
  bool is_playing(Ticks at) const { return !tree_.empty() && at < tree_.last().ends; }

  Handle state() const override { return inertialiser_.valid() ? inertialiser_ : tree_.root(has_below_); }
  void lie_over(const EntityBuilder& build, Handle below) override;
  bool update(const EntityBuilder& build) override;
  Ticks next_update() const override;
  void visit_handles(const std::function<void(Handle&)>& visit) override;
  void destroy_entities(const EntityBuilder& build) override;
  std::unique_ptr<Channel> clone() const override { return std::make_unique<SlotChannel>(*this); }

 private:
  bool take(const EntityBuilder& build, const OneShot& shot);
  void interrupt(const EntityBuilder& build, const OneShot& shot);
  void append(const EntityBuilder& build, const OneShot& shot, Ticks begins, bool fades_in);
  bool end_shots(const EntityBuilder& build);

  OneShotTree tree_;
  OneShotTree left_;  // the tree that the inertialiser is leaving
  Handle inertialiser_;
  Ticks fades_out_at_ = never;  // the last shot
  bool has_below_ = false;
  bool stops_ = false;
  bool refused_ = false;
  bool took_all_ = true;
  std::array<OneShot, OneShotTree::max_shots> asked_{};
  std::size_t asked_count_ = 0;
};

}  // namespace throng::anim
