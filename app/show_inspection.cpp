// How a person looks at level of detail: a frozen camera, lines over the crowd.
#include "app/show.h"

namespace throng::app {
namespace {

constexpr float frustum_reach = 120.0F;  // metres

}  // namespace

void Show::freeze_lod_camera() {
  if (!stage_->tuning().inspection.freeze_camera) {
    frozen_camera_.reset();
  } else if (!frozen_camera_) {
    frozen_camera_ = camera;
  }
}

void Show::gather_lines() {
  const Tuning& tuning = stage_->tuning();
  const auto aspect = static_cast<float>(width) / static_cast<float>(height);
  const auto middle = static_cast<float>(stage_->characters().front().bounds.height / 2);
  lines_.clear();
  if (frozen_camera_) add_frustum(lines_, *frozen_camera_, aspect, frustum_reach);
  if (tuning.inspection.thresholds) add_threshold_rings(lines_, tuning, lod_camera(), middle);
}

}  // namespace throng::app
