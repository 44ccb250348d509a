#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/show/figures/limiter.h"
#include "app/show/report/frame_report.h"
#include "app/window/selection_log.h"
#include "app/window/slow_frames.h"
#include "app/window/tracked_person_reporter.h"

namespace throng::app {

class Show;
class Stage;

/// Fills the report that the overlay shows, once a frame.
class FrameReporter {
 public:
  explicit FrameReporter(const Show& show);

  /// Reports the characters of the show anew; call it when they have changed.
  void describe_characters(const Show& show);
  /// Chooses the character whose roles and bones are reported; the first one at first.
  void describe_character(const Show& show, std::uint32_t character);

  /// Reports that a person asked for a part of the body in vain, until a character is described anew.
  void refuse_body(anim::BodyRole part, const std::string& why);

  /// Reports a frame that was animated and drawn. `frame_ms` is the time from its start to its end.
  void update(const Show& show, const CameraPose& camera, double frame_ms);
  /// Reports a recording that begins, until the show records no more.
  void report_recording(const std::string& file) {
    report_.recording = {.file = file, .began_at = report_.messages.now()};
  }
  /// Returns the messages to the person.
  Messages& messages() { return report_.messages; }

  /// Reports the kept frame whose number is nearest from now on, or the last ones again.
  void look_at(int frame) { slow_frames_.look_at(frame); }
  void look_at_last() { slow_frames_.look_at_last(); }

  const FrameReport& report() const { return report_; }
  /// Returns the report, for a caller that knows a part of it.
  FrameReport& report() { return report_; }

 private:
  void describe_device(const Show& show);
  void describe_bones(const anim::Character& character);
  void report_wardrobe_of(const Stage& stage);
  void add_moment(const Stage& stage);
  void add_cast(const Stage& stage);
  void add_level_of_detail(const Stage& stage);
  void add_error(const Stage& stage);
  void add_tracks(const Stage& stage);
  void add_heads(const Stage& stage);
  void add_head(const Stage& stage, const anim::VisibleAgent& agent);
  void add_units(const anim::AnimationSystem& system);

  FrameReport report_;
  LimiterOverFrames limit_;
  SelectionLog selection_log_;
  SlowFrames slow_frames_;
  TrackedPersonReporter tracked_person_;
  std::shared_ptr<const Trajectories> tracks_;        // the crowd whose people are counted
  std::shared_ptr<const anim::Character> described_;  // of the character shown
  Scene described_scene_ = Scene::plaza;              // the scene whose rules of the wardrobe were read
  std::uint64_t reported_looks_ = 0;                  // CrowdLooks::number when the wardrobe was reported
  int mesh_levels_ = 1;                               // the most of a character
};

}  // namespace throng::app
