#pragma once

#include "assets/mannequin/mesh.h"

namespace throng::wardrobe {

/// Gives every corner its place on the cloth, in metres: u around what the face lies on, 0 at the middle of the front
/// and growing to the wearer's left, v up, or along the arm. Where u comes around, faces differ.
void lay_patterns(mannequin::Skin& skin);

}  // namespace throng::wardrobe
