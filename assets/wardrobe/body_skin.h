#pragma once

#include "assets/mannequin/mesh.h"

namespace throng::wardrobe {

/// The man's whole skin with his head, cut into pieces by the notes of its faces; closed but for the eyes and the
/// mouth.
const mannequin::Skin& body_skin();

}  // namespace throng::wardrobe
