#pragma once

#include "engine/anim/kernel/choose_kernels.h"

namespace throng::app {

/// Makes the program use the SIMD target that the options of a command name from now on. Commands that pose nothing
/// have no such option.
void choose_kernels(const auto& options) {
  if constexpr (requires { options.kernels; }) {
    if (options.kernels != nullptr) anim::choose_kernels(*options.kernels);
  }
}

}  // namespace throng::app
