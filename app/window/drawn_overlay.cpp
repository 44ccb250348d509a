#include "app/window/drawn_overlay.h"

#include "app/files/data_folder.h"
#include "app/show/camera/fly_camera.h"
#include "app/show/painter.h"
#include "app/show/stage/stage.h"
#include "app/window/fixed_report.h"
#include "engine/base/files/output_file.h"

namespace throng::app {

anim::Status DrawnOverlay::begin(Show& show) {
  const auto fonts = find_data(data_folders(options_.data), "assets/fonts");
  tuning_ = show.stage().tuning();
  reporter_.emplace(show);
  if (anim::Status reported = report(show); !reported) return reported;
  overlay_ = std::make_unique<Overlay>(fonts ? *fonts : std::filesystem::path(), options_.ui_scale, tuning_);
  overlay_->show_tab(options_.ui_tab);
  if (options_.legend) overlay_->show_legend_only();
  if (anim::Status prepared = show.painter().renderer().prepare_overlay(); !prepared) return prepared;
  constexpr int frames_until_laid_out = 29;  // three would do; the more, the truer the time of one
  for (int frame = 0; frame < frames_until_laid_out; ++frame) build(show);
  return anim::Done{};
}

anim::Status DrawnOverlay::report(Show& show) {
  const FrameTimes& times = show.figures().times();
  reporter_->update(show, place_of(show.view().camera), times.animation_ms + times.drawing_ms());
  if (!options_.ui_fixed) return anim::Done{};
  const auto figures = find_data(data_folders(options_.data), "assets/fixed_report.json");
  return figures ? fix_measured(*figures, reporter_->report()) : anim::Status(figures.error());
}

void DrawnOverlay::build(Show& show) {
  StopWatch watch;
  tuning_ = show.stage().tuning();
  overlay_->begin_frame(show.view().width, show.view().height, options_.dt.value_or(usual_frame_seconds), {});
  overlay_->build(reporter_->report(), tuning_);
  show.figures().add_overlay(watch.lap());
}

anim::Status DrawnOverlay::draw(Show& show) {
  if (anim::Status reported = overlay_ == nullptr ? begin(show) : report(show); !reported) return reported;
  build(show);
  show.painter().renderer().draw_overlay(*overlay_->draw_data());
  return anim::Done{};
}

anim::Status DrawnOverlay::write_map() const {
  if (options_.ui_map.empty() || overlay_ == nullptr) return anim::Done{};
  return write_whole_file(options_.ui_map, to_json(overlay_->ui_map(), tuning_, reporter_->report()));
}

}  // namespace throng::app
