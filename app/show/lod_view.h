#pragma once

#include <span>
#include <vector>

#include "app/lod/lod_thresholds.h"
#include "engine/render/camera.h"
#include "engine/render/crowd_draw.h"

namespace throng::app {

/// Lines over the crowd that show what level of detail goes by.
using SceneLines = std::vector<render::SceneLine>;

/// What a camera sees as far as `reach` metres: its edges above the ground, and where they leave it.
void add_frustum(SceneLines& lines, const render::Camera& camera, float aspect, float reach);

/// A ring on the ground wherever agents around `camera` get another interval, in the colour of that interval.
/// `height`: metres above the ground of what distances are taken to.
void add_threshold_rings(SceneLines& lines, std::span<const IntervalThreshold> thresholds, const render::Camera& camera,
                         float height);

}  // namespace throng::app
