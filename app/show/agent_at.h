#pragma once

#include <cstdint>
#include <optional>

namespace throng::app {

class Show;

/// Returns the agent that is seen at a pixel from the top left of the picture drawn last; nothing where there is none.
std::optional<std::uint32_t> agent_at(const Show& show, float x, float y);

}  // namespace throng::app
