#include "app/demo.h"

#include <memory>

#include "app/exit_status.h"
#include "app/show.h"

namespace throng::app {
namespace {

DrawWhich drawn_frames(const DemoOptions& options) {
  return options.draw.value_or(options.screenshot.empty() ? DrawWhich::none : DrawWhich::last);
}

int write_results(Show& show, const DemoOptions& options) {
  if (!options.screenshot.empty()) {
    const render::Status written = render::write_png(show.renderer().read_image(), options.screenshot);
    if (!written) return end_with(exit_job_failed, written.error().message);
  }
  if (!options.stats.empty()) {
    const anim::Status written = show.statistics().write(options.stats, show.stage(), show.drawn_by());
    if (!written) return end_with(exit_job_failed, written.error().message);
  }
  return exit_done;
}

int run_headless(Show& show, const DemoOptions& options) {
  const anim::Ticks step = anim::to_ticks(options.dt.value_or(1.0 / 60.0));
  const DrawWhich which = drawn_frames(options);
  for (int frame = 1; frame <= options.frames; ++frame) {
    show.animate(step);
    const bool last = frame == options.frames;
    if (show.draws() && (which == DrawWhich::all || (which == DrawWhich::last && last))) show.draw();
  }
  return write_results(show, options);
}

}  // namespace

int run_demo(const DemoOptions& options) {
  Failure failure;
  const std::unique_ptr<Show> show = Show::create(options, failure);
  if (show == nullptr) return end_with(static_cast<ExitStatus>(failure.status), failure.message);
  return run_headless(*show, options);
}

}  // namespace throng::app
