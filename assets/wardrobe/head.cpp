#include "assets/wardrobe/head.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/wardrobe/head_surface.h"
#include "assets/wardrobe/part.h"

namespace throng::wardrobe {
namespace {

using glm::dvec3;
using mannequin::Region;
using mannequin::Skin;

constexpr std::array<double, 17> columns{0, 3.2, 5.8, 8.6, 14, 21, 28, 36, 46, 58, 72, 88, 104, 122, 140, 160, 180};
/// Rows of the face are where its features are; the neck and the skull have few.
constexpr std::array<double, 37> grid_rows{1.0,  2.0,  3.0,  4.0,  4.6,   5.3,   6.0,   6.33, 6.62, 6.82,
                                           6.97, 7.10, 7.27, 7.50, 7.78,  8.02,  8.17,  8.33, 8.50, 8.72,
                                           9.05, 9.40, 9.70, 9.98, 10.27, 10.62, 10.92, 11.3, 11.8, 12.4,
                                           13.0, 13.6, 14.2, 14.8, 15.3,  15.65, 15.9};
constexpr std::size_t eye_first_column = 2, eye_last_column = 8, eye_first_row = 21, eye_last_row = 25;
constexpr std::size_t lid_count = 20;

/// The left half of the head's grid, with a hole where the eye is.
class HalfHead {
 public:
  HalfHead() {
    add_grid();
    add_faces();
    add_lids();
  }
  Skin take() { return std::move(skin_); }

 private:
  [[nodiscard]] std::size_t at(std::size_t row, std::size_t column) const { return row * columns.size() + column; }

  void add_point(dvec3 place, double angle, double row) {
    if (angle == 0 || angle == 180) place.x = 0;
    skin_.points.push_back({.position = place, .weights = head_weights(place, angle, row)});
    paints_.push_back(face_paint(place));
  }

  void add_grid() {
    for (const double row : grid_rows) {
      for (const double angle : columns) add_point(head_point(angle, row), angle, row);
    }
    crown_ = skin_.points.size();
    add_point(head_point(0, head_row::crown), 0, head_row::crown);
  }

  void add_face(std::vector<std::size_t> corners) {
    std::vector<dvec3> paint;
    for (const std::size_t corner : corners) paint.push_back(paints_[corner]);
    skin_.faces.push_back({std::move(corners), Region::skin, std::move(paint), piece()});
  }

  static mannequin::FaceNotes piece() { return {.piece = static_cast<unsigned char>(Slot::head)}; }

  void add_faces() {
    for (std::size_t r = 0; r + 1 < grid_rows.size(); ++r) {
      for (std::size_t c = 0; c + 1 < columns.size(); ++c) {
        const bool in_eye = r >= eye_first_row && r < eye_last_row && c >= eye_first_column && c < eye_last_column;
        if (!in_eye) add_face({at(r, c), at(r, c + 1), at(r + 1, c + 1), at(r + 1, c)});
      }
    }
    for (std::size_t c = 0; c + 1 < columns.size(); ++c) {
      add_face({at(grid_rows.size() - 1, c), at(grid_rows.size() - 1, c + 1), crown_});
    }
  }

  /// The hole's border, from the outer side over the upper one, as the lids go around.
  [[nodiscard]] std::vector<std::size_t> hole() const {
    std::vector<std::size_t> loop;
    const std::size_t middle = (eye_first_row + eye_last_row) / 2;
    for (std::size_t r = middle; r < eye_last_row; ++r) loop.push_back(at(r, eye_last_column));
    for (std::size_t c = eye_last_column; c > eye_first_column; --c) loop.push_back(at(eye_last_row, c));
    for (std::size_t r = eye_last_row; r > eye_first_row; --r) loop.push_back(at(r, eye_first_column));
    for (std::size_t c = eye_first_column; c < eye_last_column; ++c) loop.push_back(at(eye_first_row, c));
    for (std::size_t r = eye_first_row; r < middle; ++r) loop.push_back(at(r, eye_last_column));
    return loop;
  }

  void add_lids() {
    constexpr dvec3 lash(0.10, 0.075, 0.07);
    constexpr dvec3 rim(0.86, 0.66, 0.64);
    constexpr dvec3 shadow(0.90, 0.82, 0.80);
    std::vector<std::size_t> outer = hole();
    // The fold of the lid, its edge, and the edge's inner side.
    constexpr std::array<double, 3> grow{1.34, 1.07, 0.94};
    constexpr std::array<double, 3> lift{0.0014, 0.0018, -0.0010};
    for (std::size_t ring = 0; ring < grow.size(); ++ring) {
      std::vector<std::size_t> inner;
      for (std::size_t i = 0; i < lid_count; ++i) {
        const double share = static_cast<double>(i) / lid_count;
        const bool upper = share > 0 && share < 0.5;
        dvec3 place = lid_edge(share, ring == 1 && upper ? 1.20 : grow[ring], lift[ring]);
        if (ring == 0) place.z = std::max(place.z, 0.35 * place.z + 0.65 * face_point(place.x, place.y).z);
        inner.push_back(skin_.points.size());
        add_point(place, 25, head_row::eyes);
        paints_.back() = ring == 0 ? (upper ? shadow : dvec3(0.97, 0.92, 0.91)) : upper ? lash : rim;
        if (ring == 1 && !upper) paints_.back() = dvec3(0.92, 0.78, 0.76);
      }
      for (std::size_t i = 0; i < lid_count; ++i) {
        const std::size_t next = (i + 1) % lid_count;
        add_face({outer[i], outer[next], inner[next], inner[i]});
        if (ring == 1) skin_.faces.back().paint = {shadow, shadow, shadow, shadow};
      }
      outer = inner;
    }
  }

  Skin skin_;
  std::vector<dvec3> paints_;
  std::size_t crown_ = 0;
};

}  // namespace

Skin mirrored_skin(const Skin& half) {
  Skin whole = half;
  std::vector<std::size_t> image;
  for (std::size_t p = 0; p < half.points.size(); ++p) {
    const mannequin::SkinPoint& point = half.points[p];
    if (std::abs(point.position.x) < 1e-9) {
      image.push_back(p);
      continue;
    }
    mannequin::SkinPoint other = point;
    other.position.x = -other.position.x;
    for (std::size_t j = 0; j < mannequin::joint_count; ++j) {
      other.weights[mannequin::mirrored_joint(j)] = point.weights[j];
    }
    image.push_back(whole.points.size());
    whole.points.push_back(other);
  }
  for (mannequin::SkinFace face : half.faces) {
    for (std::size_t& corner : face.corners) corner = image[corner];
    std::reverse(face.corners.begin(), face.corners.end());
    std::reverse(face.paint.begin(), face.paint.end());
    whole.faces.push_back(std::move(face));
  }
  return whole;
}

Skin head_skin() {
  Skin half = HalfHead().take();
  add_eye(half);
  add_brow(half);
  add_ear(half);
  return mirrored_skin(half);
}

}  // namespace throng::wardrobe
