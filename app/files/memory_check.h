#pragma once

#include <cstdint>
#include <string>

#include "engine/base/result.h"

namespace throng::app {

/// Checks that `needed` bytes are left, before they are taken. `what` begins the sentence of the error, and `remedy`
/// ends it: "256 PUs need 33.0 GiB of memory, but 20.1 GiB are left; ask for fewer".
Status check_memory(const std::string& what, std::uint64_t needed, const std::string& remedy);

}  // namespace throng::app
