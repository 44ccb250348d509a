#include "app/window/loading.h"

#include <filesystem>
#include <utility>

#include "app/show/show.h"

namespace throng::app {

void Loading::begin(LoadPlan plan, Then then, std::string file) {
  if (plan.is_empty()) return then(nullptr);
  if (goes_on()) cancel();
  name_ = std::filesystem::path(file.empty() ? plan.name() : file).filename().string();
  file_ = std::move(file);
  then_ = std::move(then);
  plan_ = std::make_shared<Plan>(Plan{std::move(plan), {}});
  work_ = std::make_unique<SideWork>(
      [shared = plan_](const LoadProgress& progress) { shared->loaded = load(shared->plan, progress); });
}

void Loading::cancel() {
  if (!goes_on()) return;
  messages_.say("Cancelled: " + name_ + " is not loaded");
  work_->give_up();
  given_up_.push_back(std::move(work_));
}

void Loading::finish() {
  std::erase_if(given_up_, [](const auto& work) { return work->has_ended(); });
  if (!goes_on() || !work_->has_ended()) return;
  const Status outcome = work_->outcome();
  work_.reset();
  const std::shared_ptr<Plan> plan = std::move(plan_);
  if (!outcome) return refuse(outcome.error().message);
  if (!*plan->loaded) return refuse(plan->loaded->error().message);
  Loaded loaded = std::move(**plan->loaded);
  show_.take_ahead(std::move(loaded.casts));
  std::exchange(then_, {})(std::move(loaded.tracks));
  show_.take_ahead({});  // of requests that were not made
}

void Loading::refuse(const std::string& why) {
  messages_.say((file_.empty() ? "" : file_ + ": ") + why, Message::Kind::refused);
}

std::optional<JobReport> Loading::report() const {
  if (!goes_on()) return {};
  const SideWork::Progress progress = work_->progress();
  const std::string what = progress.what.empty() ? name_ : progress.what;
  return JobReport{.job = SideJob::loading, .words = "Loading " + what, .share = progress.share};
}

}  // namespace throng::app
