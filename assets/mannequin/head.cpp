#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "assets/mannequin/body_parts.h"
#include "assets/mannequin/face_features.h"

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
    {{{{0, 1.541, 0.036}, {0.030, 1.544, 0.029}, {0.045, 1.555, 0.004}, {0.050, 1.568, -0.028}}},
     true,
     {{{0.047, 1.575, -0.056}, {0.029, 1.578, -0.080}, {0, 1.578, -0.088}}}},
    {{{{0, 1.561, 0.080}, {0.020, 1.563, 0.072}, {0.047, 1.578, 0.041}, {0.063, 1.602, -0.010}}},
     true,
     {{{0.060, 1.606, -0.054}, {0.039, 1.606, -0.090}, {0, 1.606, -0.100}}}},
    {{{{0, 1.577, 0.0915}, {0.020, 1.579, 0.083}, {0.052, 1.597, 0.049}, {0.0675, 1.622, -0.006}}}, false, {}},
    {{{{0, 1.5985, 0.0910}, {0.0230, 1.6040, 0.0825}, {0.056, 1.613, 0.053}, {0.070, 1.637, -0.003}}}, false, {}},
    {{{{0, 1.6135, 0.0950}, {0.0260, 1.6130, 0.0830}, {0.0595, 1.630, 0.057}, {0.0715, 1.650, 0.000}}},
     true,
     {{{0.071, 1.652, -0.048}, {0.050, 1.652, -0.098}, {0, 1.652, -0.112}}}},
    {{{{0, 1.630, 0.097}, {0.0175, 1.630, 0.0878}, {0.0605, 1.645, 0.0605}, {0.0725, 1.663, 0.003}}}, false, {}},
    {{{{0, 1.641, 0.117}, {0.0165, 1.641, 0.0918}, {0.0610, 1.656, 0.0635}, {0.0735, 1.674, 0.005}}}, false, {}},
    {{{{0, 1.668, 0.1040}, {0.0135, 1.664, 0.0905}, {0.0595, 1.668, 0.0665}, {0.0745, 1.687, 0.008}}}, false, {}},
    {{{{0, 1.704, 0.0975}, {0.0140, 1.705, 0.096}, {0.0565, 1.703, 0.0760}, {0.0755, 1.703, 0.022}}},
     true,
     {{{0.077, 1.704, -0.046}, {0.055, 1.704, -0.100}, {0, 1.704, -0.117}}}},
    {{{{0, 1.749, 0.086}, {0.022, 1.750, 0.084}, {0.049, 1.749, 0.067}, {0.0695, 1.740, 0.030}}},
     true,
     {{{0.0735, 1.742, -0.042}, {0.052, 1.742, -0.092}, {0, 1.742, -0.108}}}},
    {{{{0, 1.776, 0.055}, {0.019, 1.776, 0.053}, {0.042, 1.772, 0.040}, {0.054, 1.770, 0.004}}},
     true,
     {{{0.054, 1.770, -0.040}, {0.037, 1.768, -0.074}, {0, 1.768, -0.086}}}},
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
  if (column == 2) return row_below >= hairline;
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
      {{0, 1.781, 0.042}, {0, 1.785, 0.020}, {0, 1.786, -0.012}, {0, 1.784, -0.044}, {0, 1.777, -0.068}}};
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

/// Short hair, fuller at the crown and the brow than in the nape.
dvec3 comb(dvec3 position, dvec3 normal) {
  const double height = glm::clamp((position.y - 1.62) / 0.16, 0.0, 1.0);
  const double front = glm::clamp((position.z - 0.02) / 0.05, 0.0, 1.0) * height;
  return normal * (0.003 + 0.011 * height) * (1 - 0.5 * front) + dvec3(0, 0.005, 0) * front;
}

}  // namespace

void add_head(Cage& cage, const HalfRing& neck) {
  const Grid grid = add_grid(cage);
  cage.bridge(neck, grid[throat], false, Region::skin);
  const FacePatches patches = bridge_grid(cage, grid);
  add_crown(cage, grid);
  paint_lips(cage, patches.lips);
  add_ear(cage, patches.ear);
  cage.lift(Region::hair, comb);
  add_eye_and_brow(cage, patches.eye);
}

}  // namespace throng::mannequin
