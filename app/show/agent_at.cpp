#include "app/show/agent_at.h"

#include "app/show/show.h"
#include "app/show/show_view.h"
#include "app/show/stage/picking.h"
#include "app/show/stage/stage.h"

namespace throng::app {

std::optional<std::uint32_t> agent_at(const Show& show, float x, float y) {
  const auto size = glm::vec2(glm::ivec2(show.view().width, show.view().height));
  const auto picked = pick(ray_through(show.view().camera, {x, y}, size), bodies_in_view(show.stage()));
  return picked ? std::optional(picked->agent) : std::nullopt;
}

}  // namespace throng::app
