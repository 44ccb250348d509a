#pragma once

#include "throng/render/context.h"

namespace throng::render::gl {

/// Asks the device of the current context.
DeviceLimits ask_device_limits();

}  // namespace throng::render::gl
