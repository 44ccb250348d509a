#include "app/window/start_screen.h"

#include <optional>

#include "app/files/data_folder.h"
#include "app/show/painter.h"
#include "app/window/panel/overlay.h"
#include "app/window/side_work.h"
#include "app/window/stop_signals.h"
#include "app/window/window_input.h"

namespace throng::app {
namespace {

constexpr double seconds_a_frame = 0.04;
constexpr double seconds_unseen = 0.25, seconds_a_look = 0.01;  // a start that is over by then shows nothing

class StartScreen {
 public:
  StartScreen(Painter& painter, const DemoOptions& options)
      : painter_(painter),
        overlay_(fonts_folder(options.data), options.ui_scale, options.tuning),
        input_(painter.context().window()) {}

  Status prepare() { return painter_.renderer().prepare_overlay(); }

  Status draw(const SideWork::Progress& progress) {
    render::Renderer& renderer = painter_.renderer();
    const glm::ivec2 size = renderer.size();
    overlay_.begin_frame(size.x, size.y, seconds_a_frame, input_.next_frame());
    is_given_up_ = overlay_.build_start({.job = SideJob::loading,
                                         .words = progress.what.empty() ? "Starting" : progress.what,
                                         .share = progress.share});
    renderer.draw_overlay(*overlay_.draw_data(), false);
    Status drawn = renderer.finish();
    renderer.present();
    return drawn;
  }

  bool is_given_up() { return input_.takes_close() || is_given_up_ || asked_to_stop() != 0; }

 private:
  Painter& painter_;
  Overlay overlay_;
  WindowInput input_;
  bool is_given_up_ = false;
};

}  // namespace

Result<bool> show_start(Painter& painter, const DemoOptions& options, const LongWork& work) {
  SideWork side(work);
  for (double seconds = 0; !side.has_ended() && seconds < seconds_unseen; seconds += seconds_a_look) {
    WindowInput::wait(seconds_a_look);
  }
  std::optional<StartScreen> screen;
  while (!side.has_ended()) {
    if (!screen) {
      screen.emplace(painter, options);
      if (const Status prepared = screen->prepare(); !prepared) return prepared.error();
    }
    if (const Status drawn = screen->draw(side.progress()); !drawn) return drawn.error();
    if (screen->is_given_up()) return false;
    WindowInput::wait(seconds_a_frame);
  }
  if (!side.outcome()) return side.outcome().error();
  return true;
}

}  // namespace throng::app
