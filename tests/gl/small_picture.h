#pragma once

#include "app/settings/settings.h"

namespace throng::app {

/// Returns the options of pictures of that size that a processor draws, with the data of this checkout.
inline DemoOptions picture_by_processor(int width, int height) {
  DemoOptions options;
  options.context = ContextKind::egl;
  options.force_software = true;
  options.width = width;
  options.height = height;
  options.data = THRONG_SOURCE_DIR;
  return options;
}

}  // namespace throng::app
