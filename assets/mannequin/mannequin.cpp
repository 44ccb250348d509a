#include "assets/mannequin/body_parts.h"
#include "assets/mannequin/glb.h"

namespace throng::mannequin {

Mesh make_body() {
  constexpr int fitting_rounds = 4;
  return make_mesh(subdivide(fit(mirrored(build_half_body()), fitting_rounds)));
}

std::vector<std::byte> make_mannequin() { return write_glb(make_body(), make_clips()); }

}  // namespace throng::mannequin
