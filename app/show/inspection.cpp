// How a person looks at level of detail: a frozen camera, lines over the crowd, the exact crowd beside it.
#include "app/show/show.h"

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
  lines_.clear();
  if (frozen_camera_) add_frustum(lines_, *frozen_camera_, aspect, frustum_reach);
  thresholds_.update(*stage_, lod_camera(), height);
  if (!tuning.inspection.thresholds) return;
  const auto middle = static_cast<float>(stage_->characters()[thresholds_.character()].bounds.height / 2);
  add_threshold_rings(lines_, thresholds_.thresholds(), lod_camera(), middle);
}

// What is taken away to see what it costs is taken away of the usual picture.
bool Show::splits() const {
  const Tuning& tuning = stage_->tuning();
  return tuning.inspection.split != Split::off && tuning.taken_away == TakenAway{};
}

void Show::compose_exact() {
  constexpr int full_mesh = 0;
  stage_->pose_exactly();
  exact_picture_.compose(
      *stage_, [](std::uint8_t, float, int) { return full_mesh; }, Poses::exact);
}

render::DrawCounts Show::draw_pictures() {
  if (!splits()) return renderer_->draw_uploaded(crowd_frame(picture_));
  const LodInspection& look = stage_->tuning().inspection;
  return renderer_->draw_split(crowd_frame(exact_picture_), crowd_frame(picture_),
                               {.divider = look.split_at, .difference = look.split == Split::difference});
}

}  // namespace throng::app
