#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/show/load_plan.h"
#include "app/show/report/job_report.h"
#include "app/show/report/messages.h"
#include "app/window/side_work.h"

namespace throng::app {

class Show;

/// Loads what a person opens on a thread, while the crowd goes on. One plan is loaded at a time: where another comes,
/// the plan before it is given up.
class Loading {
 public:
  /// Makes the requests of a plan, whose characters the show has by then; `tracks` is its recorded crowd, or null.
  using Then = std::function<void(std::shared_ptr<const Trajectories> tracks)>;

  Loading(Show& show, Messages& messages) : show_(show), messages_(messages) {}

  /// Loads all of a plan; finish() then calls `then`. It calls it at once where there is nothing to load. A refusal
  /// begins with `file`, if it is not empty.
  void begin(LoadPlan plan, Then then, std::string file = {});
  /// Returns whether something is loaded now.
  bool goes_on() const { return work_ != nullptr; }
  /// Gives up what is loaded, and says it.
  void cancel();
  /// Makes the requests of a plan that has been loaded, or says why it cannot be. Call it at a frame boundary.
  void finish();
  std::optional<JobReport> report() const;

 private:
  /// What the thread and the window share.
  struct Plan {
    LoadPlan plan;
    std::optional<Result<Loaded>> loaded;  // once the work has ended well
  };
  void refuse(const std::string& why);

  Show& show_;
  Messages& messages_;
  std::shared_ptr<Plan> plan_;
  Then then_;
  std::string file_, name_;
  std::unique_ptr<SideWork> work_;                   // null: nothing is loaded
  std::vector<std::unique_ptr<SideWork>> given_up_;  // and not ended yet
};

}  // namespace throng::app
