#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "assets/making/buffer_writer.h"

namespace throng::making {

/// Returns a binary glTF 2.0 file of a document and its one buffer.
std::vector<std::byte> glb_container(const Json& document, std::span<const std::byte> buffer);

}  // namespace throng::making
