#pragma once

#include "engine/render/mesh/surface.h"

namespace throng::render {

/// Brings the errors of a character's mesh LODs together: each becomes the largest of all pieces that are drawn at it,
/// and no smaller than the one before. Where there are silhouettes, they take the place of other pieces from
/// first_silhouette_lod on. Where pieces have more levels than piece 0, its last one is repeated.
void take_errors_of_pieces(SurfaceParts& parts);

}  // namespace throng::render
