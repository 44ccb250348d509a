#pragma once

#include "throng/ids.h"

namespace throng::anim {
using throng::AgentId, throng::ChannelId, throng::CharacterId, throng::ProcessId;
using throng::no_number, throng::whichever;
}  // namespace throng::anim
