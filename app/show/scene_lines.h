#pragma once

#include <span>
#include <vector>

#include "throng/render/camera.h"
#include "throng/render/crowd_draw.h"

#include "app/show/lod/lod_thresholds.h"

namespace throng::app {

/// Lines over the crowd.
using SceneLines = std::vector<render::SceneLine>;

/// Adds the edges of a camera's view that lie above the ground, as far as `reach` metres, and their ends on the ground.
void add_frustum(SceneLines& lines, const render::Camera& camera, float aspect, float reach);

/// Adds a ring on the ground at each distance from `camera` where agents get another interval, in that interval's
/// colour. Distances are measured to points `height` metres above the ground.
void add_threshold_rings(SceneLines& lines, std::span<const IntervalThreshold> thresholds, const render::Camera& camera,
                         float height);

}  // namespace throng::app
