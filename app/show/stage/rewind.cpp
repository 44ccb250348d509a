#include "app/show/stage/rewind.h"

#include <utility>

#include "app/show/stage/stage.h"

namespace throng::app {

void Rewind::watch(const Stage& stage) {
  if (!moments_.empty() && moments_.back()->crowd_number != stage.animated().number()) forget();
  if (stage.tuning().agents > most_agents || stage.animated().held_clip()) return;
  if (!moments_.empty() && age(stage) < time_between) return;
  // The oldest one's memory is used again.
  const bool full = moments_.size() == most_moments;
  auto moment = full ? std::move(moments_.front()) : std::make_unique<StageMoment>();
  if (full) moments_.pop_front();
  stage.animated().remember(*moment);
  moments_.push_back(std::move(moment));
}

Status Rewind::go_back(Stage& stage, std::size_t moment) {
  if (moment >= moments_.size() || moments_.back()->crowd_number != stage.animated().number()) {
    return Error{"there is no earlier moment of this crowd to go back to"};
  }
  const auto wanted = moments_.end() - 1 - static_cast<std::ptrdiff_t>(moment);
  if (Status gone = stage.go_back_to(**wanted); !gone) return gone;
  moments_.erase(wanted, moments_.end());
  return Done{};
}

Ticks Rewind::age(const Stage& stage, std::size_t moment) const {
  if (moment >= moments_.size()) return Ticks{};
  return stage.system().clock() - moments_[moments_.size() - 1 - moment]->clock;
}

}  // namespace throng::app
