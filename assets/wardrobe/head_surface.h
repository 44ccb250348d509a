#pragma once

#include <glm/vec3.hpp>

#include "assets/mannequin/cage.h"

namespace throng::wardrobe {

/// Rows of the man's head by number: they tilt, so that one follows the jaw from the chin to the nape.
namespace head_row {
inline constexpr double neck = 0, throat = 2, jaw = 4, mouth = 7, nose = 8, eyes = 10, brow = 11, forehead = 12,
                        crown = 16;
}  // namespace head_row

/// A point of the man's skull and face. `angle` runs from 0 at the front over the left side (90 degrees) to 180 at the
/// back, in degrees; negative is the right side. `row` is between head_row::neck and head_row::crown.
glm::dvec3 head_point(double angle, double row);

/// Out of the head at that point, unit length.
glm::dvec3 head_normal(double angle, double row);

/// The point of the face at a place seen from the front.
glm::dvec3 face_point(double x, double y);
/// The angle and the row of that point.
struct HeadPlace {
  double angle, row;
};
HeadPlace face_place(double x, double y);

/// Returns how the head and the neck move a place on them.
mannequin::Weights head_weights(glm::dvec3 place, double angle, double row);

/// The albedo factor of the skin there: lips are redder, the nose and the cheeks a little.
glm::dvec3 face_paint(glm::dvec3 place);

}  // namespace throng::wardrobe
