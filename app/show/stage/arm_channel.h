#pragma once

#include "engine/anim/agent/channel.h"

namespace throng::app {

/// The clip that an arm plays over the clips of the whole body.
struct ArmClip {
  int clip = 0;
  double speed = 1.0;  ///< 0: the arm is still, as the clip begins
  int step_clip = -1;  ///< the gait that the clip keeps step with; -1: none
};

/// Plays the clip of an arm while it is asked to, and otherwise nothing, so that it costs nothing. A clip that keeps
/// step is where the gait below it is. When the gait has ended, it goes on to its first key and waits there.
class ArmChannel final : public anim::Channel {
 public:
  explicit ArmChannel(const ArmClip& clip) : clip_(clip) {}

  void turn(bool on) { is_on_ = on; }
  bool is_on() const { return is_on_; }
  bool keeps_step() const { return clip_.step_clip >= 0; }

  const char* fault(const anim::EntityBuilder& build) const override;
  anim::Handle state() const override { return player_; }
  void lie_over(const anim::EntityBuilder&, anim::Handle below) override { below_ = below; }
  bool update(const anim::EntityBuilder& build) override;
  void visit_handles(const std::function<void(anim::Handle&)>& visit) override;
  void destroy_entities(const anim::EntityBuilder& build) override;
  std::unique_ptr<anim::Channel> clone() const override { return std::make_unique<ArmChannel>(*this); }

 private:
  void keep_step(const anim::EntityBuilder& build) const;

  ArmClip clip_;
  bool is_on_ = false;
  anim::Handle player_;
  anim::Handle below_;  // the pose of the whole body
};

}  // namespace throng::app
