#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "engine/anim/asset/keyframe_stream.h"
#include "engine/anim/asset/skeleton.h"
#include "engine/anim/bake/surface.h"

namespace throng::anim {

/// The input of a sampled stream, and the bound on its error.
struct SampleSource {
  const Skeleton& skeleton;
  const SurfaceProxy& proxy;
  const KeyframeStream& exact;
  glm::dvec3 travel{0.0};  ///< root motion taken out of `exact`; it goes on before and after the clip's keys
  double error_bound = 0.0;
  std::span<const Ticks> steps{};  ///< times at which a STEP track of `exact` jumps
};

}  // namespace throng::anim
