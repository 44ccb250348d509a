#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "assets/mannequin/body_parts.h"

namespace throng::mannequin {
namespace {

using glm::dvec3;

/// The face is denser than the back of the head: rows at its front and side columns, some of which go around.
constexpr std::size_t row_count = 11;
constexpr std::size_t face_columns = 4;
constexpr std::size_t back_columns = 3;
enum Row : std::size_t {
  throat,
  jaw,
  chin,
  lower_lip,
  upper_lip,
  nose_base,
  nose_tip,
  eye_bottom,
  brow,
  hairline,
  top
};

struct FaceRow {
  std::array<dvec3, face_columns> front;  ///< Centre, nostril and inner eye, outer eye and cheek, temple.
  bool goes_around;
  std::array<dvec3, back_columns> back;  ///< Behind the ear, back, back centre.
};

constexpr std::array<FaceRow, row_count> rows{{
    {{{{0, 1.543, 0.040}, {0.030, 1.546, 0.032}, {0.049, 1.556, 0.008}, {0.056, 1.568, -0.024}}},
     true,
     {{{0.053, 1.575, -0.056}, {0.032, 1.578, -0.082}, {0, 1.578, -0.090}}}},
    {{{{0, 1.561, 0.078}, {0.021, 1.563, 0.069}, {0.046, 1.579, 0.036}, {0.062, 1.600, -0.012}}},
     true,
     {{{0.061, 1.610, -0.054}, {0.040, 1.614, -0.090}, {0, 1.614, -0.101}}}},
    {{{{0, 1.578, 0.0895}, {0.021, 1.580, 0.080}, {0.050, 1.597, 0.045}, {0.0665, 1.622, -0.006}}}, false, {}},
    {{{{0, 1.596, 0.0875}, {0.023, 1.598, 0.079}, {0.054, 1.613, 0.048}, {0.069, 1.637, -0.003}}}, false, {}},
    {{{{0, 1.617, 0.0935}, {0.025, 1.612, 0.082}, {0.057, 1.630, 0.051}, {0.071, 1.651, 0.000}}},
     true,
     {{{0.071, 1.655, -0.050}, {0.050, 1.655, -0.098}, {0, 1.655, -0.112}}}},
    {{{{0, 1.630, 0.095}, {0.017, 1.630, 0.088}, {0.059, 1.645, 0.054}, {0.072, 1.663, 0.002}}}, false, {}},
    {{{{0, 1.641, 0.117}, {0.0165, 1.640, 0.094}, {0.060, 1.655, 0.058}, {0.073, 1.672, 0.004}}}, false, {}},
    {{{{0, 1.667, 0.1035}, {0.0150, 1.664, 0.085}, {0.053, 1.664, 0.067}, {0.074, 1.685, 0.007}}}, false, {}},
    {{{{0, 1.704, 0.0965}, {0.0155, 1.704, 0.095}, {0.053, 1.702, 0.076}, {0.0755, 1.705, 0.012}}},
     true,
     {{{0.077, 1.705, -0.046}, {0.055, 1.705, -0.100}, {0, 1.705, -0.117}}}},
    {{{{0, 1.752, 0.084}, {0.022, 1.751, 0.082}, {0.053, 1.746, 0.062}, {0.071, 1.742, 0.014}}},
     true,
     {{{0.073, 1.742, -0.042}, {0.050, 1.742, -0.092}, {0, 1.742, -0.108}}}},
    {{{{0, 1.780, 0.052}, {0.019, 1.779, 0.051}, {0.041, 1.773, 0.036}, {0.052, 1.770, 0.002}}},
     true,
     {{{0.052, 1.770, -0.040}, {0.036, 1.768, -0.072}, {0, 1.768, -0.084}}}},
}};

using Grid = std::array<std::vector<std::size_t>, row_count>;

Weights head_weights(std::size_t row, std::size_t column) {
  if (row == throat) return bind({{"neck", 0.55}, {"head", 0.45}});
  const bool on_jaw = (row == jaw || row == chin || row == lower_lip) && column < 3;
  if (on_jaw) return bind({{"head", column == 2 ? 0.6 : 0.35}, {"jaw", column == 2 ? 0.4 : 0.65}});
  if (row == jaw && column > 3) return bind({{"neck", 0.25}, {"head", 0.75}});
  return bind({{"head", 1}});
}

Grid add_grid(Cage& cage) {
  Grid grid;
  for (std::size_t r = 0; r < row_count; ++r) {
    for (std::size_t c = 0; c < face_columns; ++c) grid[r].push_back(cage.add(rows[r].front[c], head_weights(r, c)));
    if (!rows[r].goes_around) continue;
    for (std::size_t c = 0; c < back_columns; ++c) {
      grid[r].push_back(cage.add(rows[r].back[c], head_weights(r, face_columns + c)));
    }
  }
  return grid;
}

bool has_hair(std::size_t row_below, std::size_t column) {
  if (column <= 1) return row_below >= hairline;
  if (column == 2) return row_below >= brow;
  if (column == 3) return row_below >= brow;
  return row_below >= jaw;
}

Region region_of(std::size_t row_below, std::size_t column) {
  return has_hair(row_below, column) ? Region::hair : Region::skin;
}

/// The patch behind the temple: one polygon takes all rows of the face that end at the ear. Returns the ear's face.
std::size_t bridge_back(Cage& cage, const Grid& grid, std::size_t low, std::size_t high) {
  std::vector<std::size_t> corners{grid[low][3], grid[low][4], grid[high][4], grid[high][3]};
  for (std::size_t r = high - 1; r > low; --r) corners.push_back(grid[r][3]);
  const std::size_t patch = cage.add_face(corners, region_of(low, 3));
  for (std::size_t c = 4; c < 6; ++c) {
    cage.add_face({grid[low][c], grid[low][c + 1], grid[high][c + 1], grid[high][c]}, region_of(low, c));
  }
  return patch;
}

struct FacePatches {
  std::size_t eye, ear, lips;
};

FacePatches bridge_grid(Cage& cage, const Grid& grid) {
  FacePatches patches{};
  std::size_t last_around = throat;
  for (std::size_t r = 0; r + 1 < row_count; ++r) {
    for (std::size_t c = 0; c + 1 < face_columns; ++c) {
      const std::size_t face =
          cage.add_face({grid[r][c], grid[r][c + 1], grid[r + 1][c + 1], grid[r + 1][c]}, region_of(r, c));
      if (r == eye_bottom && c == 1) patches.eye = face;
      if (r == lower_lip && c == 0) patches.lips = face;
    }
    if (!rows[r + 1].goes_around) continue;
    const std::size_t patch = bridge_back(cage, grid, last_around, r + 1);
    if (r + 1 == brow) patches.ear = patch;
    last_around = r + 1;
  }
  return patches;
}

/// The crown between the two halves of the top row.
void add_crown(Cage& cage, const Grid& grid) {
  constexpr std::array<dvec3, 5> parting{
      {{0, 1.787, 0.040}, {0, 1.793, 0.020}, {0, 1.795, -0.012}, {0, 1.791, -0.042}, {0, 1.783, -0.066}}};
  std::array<std::size_t, 7> centre{};
  centre.front() = grid[top].front();
  centre.back() = grid[top].back();
  for (std::size_t i = 0; i < parting.size(); ++i) centre[i + 1] = cage.add(parting[i], bind({{"head", 1}}));
  for (std::size_t j = 0; j < 6; ++j) {
    std::vector<std::size_t> corners{grid[top][j], grid[top][j + 1]};
    if (j < 5) corners.push_back(centre[j + 1]);
    if (j > 0) corners.push_back(centre[j]);
    cage.add_face(corners, Region::hair);
  }
}

std::array<std::size_t, 4> add_quad(Cage& cage, const std::array<dvec3, 4>& corners, const Weights& weights) {
  std::array<std::size_t, 4> quad{};
  for (std::size_t i = 0; i < 4; ++i) quad[i] = cage.add(corners[i], weights);
  return quad;
}

void sculpt_eye(Cage& cage, std::size_t socket) {
  constexpr dvec3 eye_paint{0.10, 0.08, 0.08};
  constexpr dvec3 socket_paint{0.90, 0.86, 0.86};
  const Weights head = bind({{"head", 1}});
  const auto eye = add_quad(
      cage, {{{0.0200, 1.6705, 0.0790}, {0.0450, 1.6705, 0.0705}, {0.0450, 1.6840, 0.0725}, {0.0200, 1.6835, 0.0810}}},
      head);
  cage.faces[socket].paint.assign(4, socket_paint);
  const std::size_t inner = cage.inset(socket, eye);
  cage.faces[inner].paint.assign(4, eye_paint);
  const std::size_t lid = cage.faces.size() - 2;  // the third of the four sides: above the eye
  const auto eyebrow = add_quad(
      cage, {{{0.0505, 1.6980, 0.0775}, {0.0170, 1.6985, 0.0935}, {0.0165, 1.6925, 0.0885}, {0.0500, 1.6925, 0.0755}}},
      head);
  const std::size_t hair = cage.inset(lid, eyebrow);
  cage.faces[hair].region = Region::hair;
}

void sculpt_ear(Cage& cage, std::size_t patch) {
  const std::vector<std::size_t> corners = cage.faces[patch].corners;
  dvec3 centre(0);
  for (const std::size_t corner : corners) centre += cage.vertices[corner].position;
  centre /= static_cast<double>(corners.size());
  std::vector<std::size_t> rim;
  for (const std::size_t corner : corners) {
    const dvec3 out = cage.vertices[corner].position - centre;
    const dvec3 at(centre.x + 0.019 + 0.05 * out.y, centre.y + out.y * 0.62, centre.z - 0.004 + out.z * 0.50);
    rim.push_back(cage.add(at, bind({{"head", 1}})));
  }
  const std::size_t ear = cage.inset(patch, rim);
  cage.faces[ear].paint.assign(rim.size(), dvec3(0.86, 0.74, 0.72));
}

void paint_lips(Cage& cage, std::size_t lips) {
  constexpr dvec3 lower(0.90, 0.62, 0.60);
  constexpr dvec3 upper(0.74, 0.46, 0.45);
  cage.faces[lips].paint = {lower, lower, upper, upper};
}

/// Short hair, fuller at the crown and the brow than in the nape.
dvec3 comb(dvec3 position, dvec3 normal) {
  const double height = glm::clamp((position.y - 1.62) / 0.16, 0.0, 1.0);
  const double front = glm::clamp((position.z - 0.02) / 0.06, 0.0, 1.0) * height;
  return normal * (0.004 + 0.010 * height) + dvec3(0, 0.008, 0.006) * front;
}

}  // namespace

void add_head(Cage& cage, const HalfRing& neck) {
  const Grid grid = add_grid(cage);
  cage.bridge(neck, grid[throat], false, Region::skin);
  const FacePatches patches = bridge_grid(cage, grid);
  add_crown(cage, grid);
  paint_lips(cage, patches.lips);
  sculpt_ear(cage, patches.ear);
  cage.lift(Region::hair, comb);
  sculpt_eye(cage, patches.eye);
}

}  // namespace throng::mannequin
