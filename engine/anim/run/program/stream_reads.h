#pragma once

#include <cstdint>

#include "engine/anim/run/program/agent_work.h"

namespace throng::anim {

/// Returns the bytes of streams that an update of this work reads (Figures::stream_bytes).
std::uint64_t stream_bytes_read(const UpdateContext& context, const AgentWork& work);

}  // namespace throng::anim
