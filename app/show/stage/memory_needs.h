#pragma once

#include <cstdint>
#include <span>

#include "app/character/source.h"
#include "app/settings/settings.h"
#include "engine/base/result.h"

namespace throng::app {

/// Checks that the PUs and the crowd of `tuning` fit into the memory that is left. `before` is the tuning in force,
/// whose memory is taken already; it is null at the start. The error names what is too large.
Status check_memory(const Tuning& tuning, std::span<const CharacterSource> characters, const Tuning* before);

/// Returns about how many bytes the local stores and the lists of all PUs take.
std::uint64_t bytes_of_pus(const anim::SystemOptions& options);

}  // namespace throng::app
