#pragma once

#include <string>
#include <vector>

#include "throng/render/image.h"

#include "app/output/regression/cases.h"
#include "app/output/regression/origin.h"
#include "app/settings/settings.h"

namespace throng::app::test {

/// Returns cases.json beside this file, whose bits and tolerances hold for the pictures of tests, too.
const RegressionCases& golden_cases();

/// Returns the contexts that this build has.
std::vector<ContextKind> golden_contexts();

/// Returns the options of a picture that can be compared: small, headless, on the software device.
DemoOptions golden_options(ContextKind context);

/// Draws what `options` ask for and holds it against `tests/golden/pictures/NAME.png`. On failure the expected and the
/// actual picture and their difference lie in the system's temporary folder, and the message names them. If
/// THRONG_UPDATE_GOLDEN is set, the picture is replaced.
void expect_golden_picture(const std::string& name, const DemoOptions& options);

/// Holds a picture that was drawn in another way against `tests/golden/pictures/NAME.png` in the same way. `run` tells
/// it from others of that name. `origin` says what made it.
void expect_golden_image(const std::string& name, const std::string& run, const render::Image& drawn,
                         const PictureOrigin& origin);

}  // namespace throng::app::test
