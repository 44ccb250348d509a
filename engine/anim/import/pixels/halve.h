#pragma once

#include "engine/anim/asset/model.h"

namespace throng::import {

/// Returns an image with half as many columns and rows, rounded up. A texel is the mean of up to four texels, as
/// they are stored.
anim::Image halved(const anim::Image& image);

}  // namespace throng::import
