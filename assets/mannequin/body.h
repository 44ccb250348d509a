#pragma once

#include "assets/mannequin/mesh.h"

namespace throng::mannequin {

/// Returns the whole body of the character.
Mesh make_body();

}  // namespace throng::mannequin
