#pragma once

#include <cstdint>

#include "engine/render/agent_look.h"

namespace throng::app {

/// Gives an agent a jaw, a nose, a brow and eyes of its own. Children's faces differ less.
void give_face(render::AgentLook& look, std::uint32_t agent, std::uint32_t seed, bool is_child);

/// Makes an agent stoop as old people do, one more than another.
void stoop(render::AgentLook& look, std::uint32_t agent, std::uint32_t seed);

}  // namespace throng::app
