#include "app/show/hands.h"

namespace throng::app {

void Hands::select(std::optional<std::uint32_t> agent) {
  stage_.select(agent);
  recorder_.add(RecordedSelection{agent});
}

void Hands::select_at(float x, float y) {
  const auto size = glm::vec2(glm::ivec2(view_.width, view_.height));
  const auto picked = pick(ray_through(view_.camera, {x, y}, size), bodies_in_view(stage_));
  select(picked ? std::optional(picked->agent) : std::nullopt);
}

anim::Status Hands::push(std::uint32_t agent, const glm::vec3& direction) {
  anim::Status pushed = stage_.animated().push_over(agent, direction);
  if (pushed) recorder_.add(RecordedPush{agent, direction});
  return pushed;
}

anim::Status Hands::push_selected() {
  const auto selected = stage_.selected();
  return selected ? push(*selected, render::forward(view_.camera)) : anim::Done{};
}

void Hands::hold_clip(std::uint32_t agent, float seconds) {
  stage_.animated().hold_clip(agent, seconds);
  recorder_.add(RecordedHold{agent, seconds});
}

void Hands::hold_selected_clip(float seconds) {
  if (const auto selected = stage_.selected()) hold_clip(*selected, seconds);
}

void Hands::let_go_of_clip() {
  stage_.animated().let_go_of_clip();
  recorder_.add(RecordedHold{});
}

}  // namespace throng::app
