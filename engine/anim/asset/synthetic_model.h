#pragma once

#include "engine/anim/asset/model.h"

namespace throng::anim {

/// A branching skeleton (a trunk with head, arms, fingers and legs) of `bones` bones, 1 to max_bones, and `clips`
/// different looping clips of LINEAR keys on a grid of `keys_per_second`, in which every bone turns and the root alone
/// moves; without a mesh. For benchmarks and tests; deterministic by `seed`.
Model synthetic_model(int bones, int clips, unsigned seed = 1, int keys_per_second = 30);

}  // namespace throng::anim
