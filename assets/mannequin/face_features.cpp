#include "assets/mannequin/face_features.h"

#include <array>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "assets/mannequin/body_parts.h"

namespace throng::mannequin {
namespace {

using glm::dvec2;
using glm::dvec3;

std::array<std::size_t, 4> add_quad(Cage& cage, const std::array<dvec3, 4>& corners, const Weights& weights) {
  std::array<std::size_t, 4> quad{};
  for (std::size_t i = 0; i < 4; ++i) quad[i] = cage.add(corners[i], weights);
  return quad;
}

}  // namespace

void add_eye_and_brow(Cage& cage, std::size_t socket) {
  constexpr dvec3 socket_paint{1.0, 0.97, 0.97};
  constexpr dvec3 lash_paint{0.05, 0.035, 0.03};
  constexpr dvec3 white_paint{0.47, 0.45, 0.43};
  constexpr dvec3 iris_paint{0.045, 0.025, 0.015};
  const Weights head = bind({{"head", 1}});
  const auto almond = add_quad(
      cage, {{{0.0215, 1.6680, 0.0828}, {0.0430, 1.6682, 0.0768}, {0.0450, 1.6820, 0.0780}, {0.0200, 1.6815, 0.0846}}},
      head);
  const auto iris = add_quad(
      cage, {{{0.0258, 1.6688, 0.0837}, {0.0388, 1.6688, 0.0804}, {0.0388, 1.6808, 0.0810}, {0.0258, 1.6808, 0.0844}}},
      bind({{"eye.L", 1}}));
  cage.faces[socket].paint.assign(4, socket_paint);
  cage.inset(socket, almond);
  const std::size_t lid = cage.faces.size() - 2;  // the third of the four sides: above the eye
  cage.faces[socket].paint.assign(4, white_paint);
  cage.faces[socket].region = Region::untinted;
  cage.inset(socket, iris, true);
  cage.faces[cage.faces.size() - 2].paint.assign(4, lash_paint);
  cage.faces[socket].paint.assign(4, iris_paint);
  const auto eyebrow = add_quad(
      cage, {{{0.0480, 1.6972, 0.0792}, {0.0225, 1.6982, 0.0905}, {0.0228, 1.6934, 0.0882}, {0.0475, 1.6930, 0.0785}}},
      head);
  const std::size_t hair = cage.inset(lid, eyebrow);
  cage.faces[hair].region = Region::hair;
}

void add_ear(Cage& cage, std::size_t patch) {
  constexpr dvec3 hollow_paint{0.80, 0.66, 0.64};
  const std::vector<std::size_t> corners = cage.faces[patch].corners;
  dvec3 centre(0);
  for (const std::size_t corner : corners) centre += cage.vertices[corner].position;
  centre /= static_cast<double>(corners.size());
  centre.z -= 0.006;
  const Weights head = bind({{"head", 1}});
  std::vector<std::size_t> root;
  std::vector<std::size_t> rim;
  for (const std::size_t corner : corners) {
    const dvec3 out = cage.vertices[corner].position - centre;
    const dvec2 around = glm::normalize(dvec2(out.z, out.y));
    root.push_back(cage.add({centre.x, centre.y + 0.018 * around.y, centre.z + 0.009 * around.x}, head));
    rim.push_back(cage.add({centre.x + 0.011 - 0.005 * around.x - 0.001 * around.y, centre.y + 0.003 + 0.026 * around.y,
                            centre.z - 0.006 + 0.0165 * around.x},
                           head));
  }
  cage.inset(patch, root, true);
  cage.inset(patch, rim, true);
  cage.faces[patch].paint.assign(rim.size(), hollow_paint);
}

void paint_lips(Cage& cage, std::size_t lips) {
  constexpr dvec3 lower(0.92, 0.70, 0.68);
  constexpr dvec3 upper(0.78, 0.55, 0.53);
  cage.faces[lips].paint = {lower, lower, upper, upper};
}

}  // namespace throng::mannequin
