#pragma once

#include <string>

#include "app/settings/settings.h"
#include "engine/render/image.h"

namespace throng::app::test {

// Two thresholds, in steps of 255, as pictures of one scene differ between processors with and without AVX: their
// rasterisers round outlines differently, and texture filtering in the last bit.

/// The largest mean over the whole picture. Outlines are about a tenth of it and move by a few steps. A light that
/// changes moves all of it.
inline constexpr double largest_mean_difference = 0.8;
/// The largest mean over the worst block of 16x16 pixels. Outlines alone reach 6. A missing hand, which is as large as
/// a block, reaches 15 and more.
inline constexpr double largest_block_difference = 9.0;

/// Returns the options of a picture that can be compared: small, headless, on the software device.
DemoOptions golden_options(ContextKind context);

/// Leaves nothing behind a panel but a sky without clouds, so that the picture compresses.
void look_at_plain_sky(DemoOptions& options);

/// Draws what `options` ask for and holds it against `tests/golden/pictures/NAME.png`. On failure the expected and the
/// actual picture and their difference lie in the system's temporary folder, and the message names them. If
/// THRONG_UPDATE_GOLDEN is set, the picture is replaced.
void expect_golden_picture(const std::string& name, const DemoOptions& options);

/// Holds a picture that was drawn in another way against `tests/golden/pictures/NAME.png` in the same way. `run` tells
/// it from others of that name.
void expect_golden_image(const std::string& name, const std::string& run, const render::Image& drawn);

}  // namespace throng::app::test
