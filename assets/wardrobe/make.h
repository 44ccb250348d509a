#pragma once

#include <functional>

#include "assets/mannequin/cage.h"
#include "assets/mannequin/mesh.h"
#include "assets/wardrobe/part.h"

namespace throng::wardrobe {

// Makers of parts use these functions. All places are metres on the naked man at rest (assets/README.md, "The
// wardrobe").

/// The left half of the naked man's cage below the middle of the neck, where it is open; `notes.piece` of a face is its
/// piece (a Slot).
const mannequin::Cage& man_cage();

/// The smooth surface of the naked man, whole, with his head.
const mannequin::Skin& man_skin();

/// Weights of the nearest point of the naked man: cloth that lies there bends as the skin does.
mannequin::Weights weights_at(glm::dvec3 place);
/// The same, of the given pieces alone, so that a sleeve does not take the weights of the ribs.
mannequin::Weights weights_at(glm::dvec3 place, std::initializer_list<Slot> pieces);

/// Mirrors half a cage (x >= 0, open along x = 0), makes the surface pass through its vertices, smooths it once.
mannequin::Skin mirrored_surface(const mannequin::Cage& half);
/// The same for a cage that is whole already.
mannequin::Skin whole_surface(const mannequin::Cage& cage);

/// A closed ring of `n` vertices; `place` maps 0..1 to where a vertex is. Anticlockwise seen from where the outside of
/// a bridge's upper ring lies, as in the cages of the mannequin.
std::vector<std::size_t> add_ring(mannequin::Cage& cage, std::size_t n,
                                  const std::function<glm::dvec3(double share)>& place,
                                  const std::function<mannequin::Weights(glm::dvec3)>& weights);

/// The pieces of the man's skin, lifted by some metres along its normals: what lies close to the body.
/// Its borders are open; `keep` says of a face's middle whether the face is part of it.
mannequin::Cage shell(
    std::initializer_list<Slot> pieces, mannequin::Region region, const std::function<double(glm::dvec3)>& lift,
    const std::function<bool(glm::dvec3)>& keep = [](glm::dvec3) { return true; });

/// The man's own skin of a piece above a height, for what leaves only that of the piece bare.
mannequin::Skin bare_skin(Slot piece, double above);

/// Puts the faces of one surface behind those of another.
void append(mannequin::Skin& all, const mannequin::Skin& more);

}  // namespace throng::wardrobe
