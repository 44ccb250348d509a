#pragma once

#include <span>
#include <vector>

#include "engine/anim/asset/model.h"
#include "engine/anim/base/box.h"
#include "engine/anim/base/transform.h"

namespace throng::anim {

/// Returns, for each palette entry, the box of the surface that it moves, in the space of the palette. An entry that
/// moves none has an empty box. A model without surface has the boxes of its joints.
std::vector<Box> entry_boxes(const Model& model);

/// Returns a box that holds the surface as a palette with all bones poses it, in model space.
Box posed_box(std::span<const Box> entry_boxes, std::span<const PaletteMatrix> palette);

}  // namespace throng::anim
