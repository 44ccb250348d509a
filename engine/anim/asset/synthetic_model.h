#pragma once

#include "engine/anim/asset/model.h"

namespace throng::anim {

/// Makes a branching skeleton (a trunk with head, arms, fingers and legs) of `bones` bones, 1 to max_bones, and `clips`
/// different looping clips, without a mesh, for benchmarks and tests. Keys are LINEAR on a grid of `keys_per_second`.
/// Every bone turns, and the root alone moves. The same `seed` gives the same model.
Model synthetic_model(int bones, int clips, unsigned seed = 1, int keys_per_second = 30);

}  // namespace throng::anim
