#pragma once

#include "app/commands/bake/options.h"

namespace throng::app {

/// Bakes all characters of the models into one pack, and lists its contents. Returns the exit status. The pack is
/// written whole or not at all.
int run_bake(const BakeOptions& options);

}  // namespace throng::app
