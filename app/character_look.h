#pragma once

#include <array>
#include <cstdint>

#include "app/crowd_random.h"
#include "engine/render/instance_record.h"

namespace throng::app {

/// One colour a tint region (skin, hair, shirt, trousers, shoes): RGBA8, sRGB, red in the lowest byte, alpha 255.
using Tints = std::array<std::uint32_t, render::tint_regions>;

/// Clothes, hair and skin of one person: muted colours for most, an accent here and there.
Tints random_tints(Random& random);

}  // namespace throng::app
