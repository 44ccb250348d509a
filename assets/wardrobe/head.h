#pragma once

#include "assets/mannequin/mesh.h"

namespace throng::wardrobe {

/// The man's head without hair: neck, face, eyes, ears, brows. Its lower border is an open ring of the neck.
mannequin::Skin head_skin();

/// Adds what stands on a surface of its own: eyeballs, brows, ears. Left sides only; they are mirrored later.
void add_eye(mannequin::Skin& half);
void add_brow(mannequin::Skin& half);
void add_ear(mannequin::Skin& half);

/// The lid's edge around the left eye by share of a turn, from the outer corner over the upper lid; metres.
glm::dvec3 lid_edge(double share, double grow, double lift);

/// Adds the mirror image of half a surface; points on the plane x = 0 are shared.
mannequin::Skin mirrored_skin(const mannequin::Skin& half);

}  // namespace throng::wardrobe
