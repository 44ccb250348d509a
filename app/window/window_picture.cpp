#include "app/window/window_picture.h"

#include <cmath>

#include "app/show/painter.h"
#include "app/show/report/messages.h"
#include "app/show/show.h"
#include "app/show/show_view.h"
#include "app/show/stage/stage.h"
#include "app/window/panel/overlay.h"

namespace throng::app {

Status WindowPicture::prepare(Overlay& overlay) {
  if (show_.painter().is_on_software()) overlay.leave_ground_out();
  return show_.painter().renderer().prepare_overlay();
}

void WindowPicture::fit_to_window() {
  ShowView& view = show_.view();
  const glm::ivec2 size = show_.painter().context().framebuffer_size();
  minimised_ = size.x <= 0 || size.y <= 0;
  if (minimised_ || size == glm::ivec2(view.width, view.height)) return;
  const bool fits = messages_.report(show_.painter().renderer().set_size(size));
  if (!fits) return;  // the picture keeps its size and is stretched
  view.width = size.x;
  view.height = size.y;
}

Status WindowPicture::present(Overlay& overlay) {
  if (minimised_) return Done{};
  ShowView& view = show_.view();
  render::Renderer& renderer = show_.painter().renderer();
  const UiRectangle crowd = overlay.crowd_area();
  view.covered = 1.0F - crowd.width / static_cast<float>(view.width);
  if (show_.painter().is_on_software()) {
    // A processor that draws leaves out the part under the panel, which is half of its work.
    const int height = static_cast<int>(std::ceil(crowd.height));
    renderer.draw_only({{0, view.height - height}, {static_cast<int>(std::ceil(crowd.width)), height}},
                       Overlay::panel_color());
  }
  Status drawn = show_.draw();
  const bool is_first = show_.stage().posed().frame() <= 1;
  if (messages_.report(drawn) || !is_first) drawn = Done{};
  renderer.draw_overlay(*overlay.draw_data());
  renderer.present();
  return drawn;
}

void WindowPicture::build_saved_shaders(Clock::time_point now) {
  if (now < next_look_at_shaders_) return;
  next_look_at_shaders_ = now + std::chrono::milliseconds(500);
  render::Renderer& renderer = show_.painter().renderer();
  if (renderer.shaders_are_out_of_date()) {
    messages_.report(renderer.reload_shaders(), "Built the shaders, which were saved");
  }
}

}  // namespace throng::app
