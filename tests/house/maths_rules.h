#pragma once

#include "tests/house/house_rules.h"

namespace throng::house {

/// No code of engine/anim calls a function of angles, a logarithm or a power of the C library, nor one of GLM that
/// does: each system rounds these in its own way. engine/anim/base/elementary.h has ours. Level of detail, the error of
/// skipped frames and the guess of a scale are free to call them, since they decide which poses are made and no bit
/// of one. The examples are free, too.
Findings rounded_by_the_system(const Tree& tree);

}  // namespace throng::house
