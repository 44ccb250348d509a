#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/settings/settings.h"
#include "app/settings/tuning_pair.h"
#include "app/show/camera/camera_bookmarks.h"
#include "app/show/request/chosen_character.h"
#include "engine/tracks/track_clock.h"

namespace throng::app {

/// How a recorded crowd is looked at.
struct RecordedView {
  TrackClock clock;
  std::optional<CameraPose> camera;  ///< none: it moves by itself
};

/// The parts of a person's work that no preset holds.
struct CrowdWork {
  std::vector<ChosenCharacter> characters = {};
  CameraBookmarks places = {};
  std::optional<RecordedView> recorded = {};  ///< none: no recorded crowd is shown
};

/// Knows which part of a person's work is in no file.
class UnsavedWork {
 public:
  /// Takes the values that a person began with, kept as a preset, or took from one.
  explicit UnsavedWork(const Tuning& begun_with) { keep(begun_with); }
  /// `pair` has the values to compare them with. Values that wait there stay kept if they were kept.
  void keep(const Tuning& tuning, const TuningPair& pair = {});
  /// Takes the values that wait, kept as a preset or taken from one.
  void keep_other(const Tuning& tuning);
  /// Takes the work of a crowd file, or that a person began with.
  void keep(const CrowdWork& work) { kept_work_ = work; }
  /// Takes characters that a person opened.
  void keep(const std::vector<ChosenCharacter>& characters) { kept_work_.characters = characters; }

  /// Returns the parts that no file has, a phrase each. The time of a recorded crowd that plays passes by itself, so a
  /// time counts where it stands still.
  std::vector<std::string> parts(const Tuning& tuning, const TuningPair& pair, const CrowdWork& work) const;

 private:
  bool is_kept(const Tuning& worth_keeping) const { return worth_keeping == kept_ || worth_keeping == kept_other_; }

  Tuning kept_;
  std::optional<Tuning> kept_other_;
  CrowdWork kept_work_;
};

}  // namespace throng::app
