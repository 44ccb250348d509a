#include "app/show/agent_at.h"

#include "app/show/show.h"
#include "app/show/stage/picking.h"

namespace throng::app {

std::optional<std::uint32_t> agent_at(const Show& show, float x, float y) {
  const auto size = glm::vec2(glm::ivec2(show.width, show.height));
  const auto picked = pick(ray_through(show.camera, {x, y}, size), bodies_in_view(show.stage()));
  return picked ? std::optional(picked->agent) : std::nullopt;
}

}  // namespace throng::app
