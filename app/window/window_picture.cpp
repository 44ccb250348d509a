#include "app/window/window_picture.h"

#include <cmath>

#include <glm/common.hpp>

#include "app/show/painter.h"
#include "app/show/report/messages.h"
#include "app/show/show.h"
#include "app/show/show_view.h"
#include "app/show/stage/stage.h"
#include "app/window/panel/overlay.h"

namespace throng::app {
namespace {

constexpr int frames_after_use = 15;  // in which the panel may move still
constexpr int frames_a_panel = 4;

}  // namespace

WindowPicture::WindowPicture(Show& show, Messages& messages)
    : show_(show), messages_(messages), size_(show.view().width, show.view().height) {}

Status WindowPicture::prepare(Overlay& overlay) {
  if (show_.painter().is_on_software()) overlay.leave_ground_out();
  return show_.painter().renderer().prepare_overlay();
}

void WindowPicture::scale(Overlay& overlay, float scale) {
  if (overlay.set_scale(scale)) messages_.report(show_.painter().renderer().prepare_overlay());
}

void WindowPicture::fit_to_window(bool out_of_sight) {
  ShowView& view = show_.view();
  const glm::ivec2 size = show_.painter().context().framebuffer_size();
  is_seen_ = !out_of_sight && size.x > 0 && size.y > 0;
  if (!is_seen_) return;
  const glm::ivec2 drawn = glm::max((size * show_.stage().tuning().picture_size + 50) / 100, glm::ivec2(1));
  if (size == size_ && drawn == glm::ivec2(view.width, view.height)) return;
  const bool fits = messages_.report(show_.painter().renderer().set_size(size, drawn));
  if (!fits) return;  // the picture keeps its size and is stretched
  size_ = size;
  frames_with_panel_ = frames_after_use;
  view.width = drawn.x;
  view.height = drawn.y;
}

bool WindowPicture::keeps_panel(bool is_used) {
  if (is_used) frames_with_panel_ = frames_after_use;
  if (!show_.painter().is_on_software() || frames_with_panel_-- > 0) return false;
  frames_with_panel_ = 0;
  frames_without_panel_ = (frames_without_panel_ + 1) % frames_a_panel;
  return frames_without_panel_ != 0;
}

Status WindowPicture::present(Overlay& overlay, bool is_used) {
  if (!is_seen_) return Done{};
  render::Renderer& renderer = show_.painter().renderer();
  const UiRectangle crowd = overlay.crowd_area();
  if (show_.painter().is_on_software()) {
    // A processor that draws leaves out the part under the panel, which is half of its work.
    const int height = static_cast<int>(std::ceil(crowd.height));
    renderer.draw_only({{0, size_.y - height}, {static_cast<int>(std::ceil(crowd.width)), height}},
                       Overlay::panel_color());
  }
  Status drawn = show_.draw();
  renderer.draw_overlay(*overlay.draw_data(), keeps_panel(is_used));
  const Status finished = renderer.finish();
  if (drawn) drawn = finished;
  const bool is_first = show_.stage().posed().frame() <= 1;
  if (messages_.report(drawn) || !is_first) drawn = Done{};
  drawn_at_ = Clock::now();
  renderer.present();
  if (show_.painter().is_on_software()) drawn_at_ = Clock::now();  // it copies the picture, and waits for no screen
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
