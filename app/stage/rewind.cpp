#include "app/stage/rewind.h"

#include <utility>

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

anim::Status Rewind::go_back(Stage& stage) {
  if (moments_.empty() || moments_.back()->crowd_number != stage.animated().number()) {
    return anim::Error{"there is no earlier moment of this crowd to go back to"};
  }
  if (anim::Status gone = stage.go_back_to(*moments_.back()); !gone) return gone;
  moments_.pop_back();
  return anim::Done{};
}

anim::Ticks Rewind::age(const Stage& stage, std::size_t moment) const {
  if (moment >= moments_.size()) return anim::Ticks{};
  return stage.system().clock() - moments_[moments_.size() - 1 - moment]->clock;
}

}  // namespace throng::app
