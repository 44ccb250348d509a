#include "app/overlay/tuning_pair.h"

#include <utility>

namespace throng::app {

void TuningPair::change_places(Tuning& tuning) {
  shows_b_ = !shows_b_;
  if (!other_) other_ = tuning;
  other_->paused = tuning.paused;
  other_->inspection = tuning.inspection;
  std::swap(*other_, tuning);
}

}  // namespace throng::app
