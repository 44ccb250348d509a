#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/show/load_plan.h"
#include "app/show/request/crowd_file.h"
#include "app/show/request/request.h"
#include "app/show/request_history.h"

namespace throng::app {

class FrameReporter;
class Show;

/// Changes a crowd as a person asks: it makes requests, says what came of them, and takes them back.
class CrowdEditor {
 public:
  CrowdEditor(Show& show, FrameReporter& reporter);

  /// Makes a request, which may come from a `file`. Returns whether it was made; if not, the person is told why.
  bool take(const CrowdRequest& request, const std::string& file = {});
  /// Returns the plan to load what a crowd file names. Errors: the window cannot show it now.
  Result<LoadPlan> plan_to_open(const CrowdSetup& setup) const;
  /// Opens all that a crowd file holds: the characters, the recorded crowd, which was loaded, the values and the
  /// camera. Returns whether the crowd is there; if not, the person is told why.
  bool open(const CrowdSetup& setup, const std::string& file, const ShownTracks& tracks);
  /// Takes values that are no step to take back, such as the values of the other of two tunings.
  bool take_in_passing(const Tuning& tuning) { return make(Apply{tuning}); }
  /// Shows a recorded crowd, and a step back shows what was there. A live crowd that was there does not come back.
  /// Returns whether it is shown; if not, the person is told why.
  bool take(const ShownTracks& tracks);
  /// Takes the last change back, or makes it again. The pause is no part of it.
  void undo();
  void redo();
  /// Returns the plan to load what undo() or redo() brings back.
  LoadPlan plan_to_undo() const;
  LoadPlan plan_to_redo() const;
  /// Ends a change: later requests are another step.
  void end_change() { ++change_; }
  /// Returns whether undo() would take back another order of bones.
  bool can_undo_bones() const;

  /// Returns the values that the person asked for last and that could be.
  const Tuning& tuning() const { return tuning_; }
  /// Takes the values of the show, which something else has changed.
  void follow();

 private:
  bool make(const CrowdRequest& request, const std::string& file = {});
  bool refuse(const std::string& file, const std::string& why);
  bool make_all(const std::vector<CrowdRequest>& requests);
  bool show_tracks(const ShownTracks& tracks);
  /// Forgets the recorded crowd that is not shown any more. A step back shows it again, with the values of `before`.
  void forget_tracks(const Tuning& before);
  void say_what_came_of(const CrowdRequest& request);
  void say_why_not(const CrowdRequest& request, const std::string& why);

  Show& show_;
  FrameReporter& reporter_;
  Tuning tuning_;
  RequestHistory history_;
  std::uint64_t change_ = 0;
};

}  // namespace throng::app
