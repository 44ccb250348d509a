#include "app/overlay/crowd_click.h"

#include <cmath>
#include <utility>

namespace throng::app {
namespace {

constexpr float most_movement = 4.0F;  // pixels that a hand moves while it clicks

}  // namespace

std::optional<PicturePoint> CrowdClick::update(const InputFrame& input, bool pointer_free) {
  const bool down = input.down(MouseButton::left), was_down = std::exchange(was_down_, down);
  if (down && !was_down && pointer_free) pressed_at_ = PicturePoint{input.pointer_x, input.pointer_y};
  if (!pressed_at_) return std::nullopt;
  const float moved = std::hypot(input.pointer_x - pressed_at_->x, input.pointer_y - pressed_at_->y);
  if (moved > most_movement) pressed_at_.reset();
  return down ? std::nullopt : std::exchange(pressed_at_, std::nullopt);
}

}  // namespace throng::app
