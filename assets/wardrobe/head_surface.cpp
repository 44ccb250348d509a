#include "assets/wardrobe/head_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/mannequin/curve.h"

namespace throng::wardrobe {
namespace {

using glm::dvec3;
using mannequin::CurveKey;

/// Describes a row by its places in front, at the left side and at the back, and how boxy it is (1: an ellipse).
struct HeadRow {
  double front_y, front_z, half_width, side_y, side_z, back_y, back_z, front_box, back_box;
};

constexpr std::size_t row_count = 17;
constexpr std::array<HeadRow, row_count> head_rows{{
    {1.486, 0.036, 0.0585, 1.516, -0.021, 1.524, -0.0775, 1.00, 1.00},
    {1.514, 0.032, 0.0540, 1.546, -0.023, 1.552, -0.0775, 1.00, 1.00},
    {1.541, 0.038, 0.0520, 1.570, -0.024, 1.578, -0.083, 1.00, 1.00},
    {1.5535, 0.064, 0.0570, 1.586, -0.018, 1.598, -0.0925, 1.00, 1.00},
    {1.5610, 0.0805, 0.0610, 1.598, -0.014, 1.610, -0.101, 0.98, 0.98},
    {1.5740, 0.0878, 0.0645, 1.612, -0.010, 1.624, -0.106, 0.96, 0.96},
    {1.5900, 0.0884, 0.0672, 1.628, -0.007, 1.640, -0.110, 0.94, 0.94},
    {1.6060, 0.0889, 0.0695, 1.644, -0.004, 1.656, -0.113, 0.92, 0.92},
    {1.6280, 0.0895, 0.0712, 1.660, -0.002, 1.670, -0.115, 0.90, 0.90},
    {1.6520, 0.0905, 0.0728, 1.675, -0.001, 1.681, -0.1165, 0.88, 0.88},
    {1.6770, 0.0905, 0.0740, 1.691, 0.000, 1.693, -0.1175, 0.86, 0.88},
    {1.7030, 0.0935, 0.0750, 1.708, -0.001, 1.709, -0.117, 0.84, 0.88},
    {1.7250, 0.0915, 0.0750, 1.726, -0.004, 1.727, -0.114, 0.84, 0.90},
    {1.7500, 0.0800, 0.0695, 1.749, -0.010, 1.749, -0.105, 0.90, 0.93},
    {1.7710, 0.0600, 0.0565, 1.769, -0.014, 1.768, -0.088, 0.96, 0.98},
    {1.7850, 0.0310, 0.0345, 1.784, -0.018, 1.783, -0.061, 1.00, 1.00},
    {1.7905, -0.0180, 0.0, 1.7905, -0.018, 1.7905, -0.018, 1.00, 1.00},
}};

/// A member of the rows as a smooth curve over their numbers.
double along_rows(double HeadRow::*member, double row) {
  std::array<CurveKey, row_count> keys{};
  for (std::size_t r = 0; r < row_count; ++r) keys[r] = {static_cast<double>(r), head_rows[r].*member};
  return mannequin::open_curve(keys, row);
}

double face_bump(dvec3 p, double x, double y, double wide, double high) {
  const double u = (std::abs(p.x) - x) / wide;
  const double v = (p.y - y) / high;
  return std::exp(-u * u - v * v);
}

/// Returns how far the nose stands out at a place.
double nose(dvec3 p) {
  constexpr std::array<CurveKey, 8> height{{{1.6255, 0.0},
                                            {1.6300, 0.006},
                                            {1.6350, 0.0170},
                                            {1.6405, 0.0222},
                                            {1.6480, 0.0205},
                                            {1.6660, 0.0115},
                                            {1.6860, 0.0050},
                                            {1.7060, 0.0}}};
  constexpr std::array<CurveKey, 4> width{{{1.630, 0.0076}, {1.641, 0.0080}, {1.655, 0.0070}, {1.690, 0.0085}}};
  const double across = std::abs(p.x) / mannequin::open_curve(width, p.y);
  const double ridge = mannequin::open_curve(height, p.y) * std::exp(-std::pow(across, 2.1));
  const double under = glm::smoothstep(1.6265, 1.6335, p.y);
  return ridge + 0.0078 * under * face_bump(p, 0.0108, 1.6365, 0.0050, 0.0064);
}

constexpr double mouth_half_width = 0.0255;

double mouth_line(double x) { return 1.6055 + 0.0042 * (x / mouth_half_width) * (x / mouth_half_width); }

/// Returns where on the lips a place is: 0 at the mouth's line, 1 at the edge of the upper lip, -1 at that of the
/// lower, and more beyond the lips.
double on_lips(dvec3 p) {
  const double along = std::min(std::abs(p.x) / mouth_half_width, 1.0);
  const double from_line = p.y - mouth_line(p.x);
  const double bow = 1 - 0.22 * std::exp(-std::pow(p.x / 0.0045, 2.0));
  const double upper = 0.0095 * (1 - std::pow(along, 1.8)) * bow + 0.0004;
  const double lower = 0.0112 * (1 - std::pow(along, 2.2)) + 0.0004;
  return from_line > 0 ? from_line / upper : from_line / lower;
}

double lips(dvec3 p) {
  if (std::abs(p.x) > mouth_half_width + 0.004) return 0;
  const double at = on_lips(p);
  const double along = std::min(std::abs(p.x) / mouth_half_width, 1.0);
  const double fading = 1 - std::pow(along, 3.0);
  const double swell = std::abs(at) < 1.3 ? std::max(0.0, 1 - std::pow((std::abs(at) - 0.55) / 0.75, 2.0)) : 0.0;
  const double line = std::exp(-std::pow((p.y - mouth_line(p.x)) / 0.0016, 2.0));
  return fading * ((at > 0 ? 0.0032 : 0.0044) * swell - 0.0026 * line);
}

dvec3 sculpted(dvec3 p) {
  const double front = glm::smoothstep(0.0, 0.035, p.z);
  if (front <= 0) return p;
  double out = nose(p) + lips(p);
  out -= 0.0065 * face_bump(p, 0.0270, 1.6830, 0.0170, 0.0130);  // sockets
  out -= 0.0030 * face_bump(p, 0.0150, 1.6780, 0.0075, 0.0120);  // beside the root of the nose
  out += 0.0030 * face_bump(p, 0.0270, 1.7060, 0.0220, 0.0085);  // brows
  out += 0.0035 * face_bump(p, 0.0420, 1.6450, 0.0170, 0.0170);  // cheeks
  out += 0.0040 * face_bump(p, 0.0000, 1.5720, 0.0190, 0.0100);  // chin
  out -= 0.0042 * face_bump(p, 0.0000, 1.5895, 0.0190, 0.0058);
  p.z += front * out;
  p.x += std::copysign(front * 0.0020, p.x) * face_bump(p, 0.0520, 1.6480, 0.0150, 0.0180);
  return p;
}

double signed_power(double value, double exponent) { return std::copysign(std::pow(std::abs(value), exponent), value); }

}  // namespace

dvec3 head_point(double angle, double row) {
  const double turn = std::abs(angle) * std::numbers::pi / 180;
  const double sine = std::sin(turn);
  const double cosine = std::cos(turn);
  const double box = along_rows(cosine > 0 ? &HeadRow::front_box : &HeadRow::back_box, row);
  const double side_box = 0.5 * (along_rows(&HeadRow::front_box, row) + along_rows(&HeadRow::back_box, row));
  const double side_y = along_rows(&HeadRow::side_y, row);
  const double side_z = along_rows(&HeadRow::side_z, row);
  const double end_y = along_rows(cosine > 0 ? &HeadRow::front_y : &HeadRow::back_y, row);
  const double end_z = along_rows(cosine > 0 ? &HeadRow::front_z : &HeadRow::back_z, row);
  const double fore = std::pow(std::abs(cosine), box);
  const double across = signed_power(sine, glm::mix(side_box, box, std::abs(cosine)));
  const double tilt = fore * fore * (1.5 - 0.5 * fore);
  const dvec3 left = sculpted(
      {along_rows(&HeadRow::half_width, row) * across, glm::mix(side_y, end_y, tilt), glm::mix(side_z, end_z, fore)});
  return {angle < 0 ? -left.x : left.x, left.y, left.z};
}

dvec3 head_normal(double angle, double row) {
  constexpr double step = 0.4;
  if (row > head_row::crown - 0.05) return {0, 1, 0};
  const double up = std::min(row + 0.05, head_row::crown);
  const dvec3 around = head_point(angle + step, row) - head_point(angle - step, row);
  const dvec3 upwards = head_point(angle, up) - head_point(angle, std::max(row - 0.05, 0.0));
  return glm::normalize(glm::cross(upwards, around) * -1.0);
}

HeadPlace face_place(double x, double y) {
  HeadPlace place{0, head_row::nose};
  for (int round = 0; round < 6; ++round) {
    double low = head_row::throat, high = head_row::crown;
    for (int i = 0; i < 40; ++i) {
      place.row = 0.5 * (low + high);
      (head_point(place.angle, place.row).y < y ? low : high) = place.row;
    }
    low = 0, high = 90;
    for (int i = 0; i < 40; ++i) {
      place.angle = 0.5 * (low + high);
      (head_point(place.angle, place.row).x < std::abs(x) ? low : high) = place.angle;
    }
  }
  if (x < 0) place.angle = -place.angle;
  return place;
}

dvec3 face_point(double x, double y) {
  const HeadPlace place = face_place(x, y);
  return head_point(place.angle, place.row);
}

mannequin::Weights head_weights(dvec3 place, double angle, double row) {
  const double back = 0.5 - 0.5 * std::cos(angle * std::numbers::pi / 180);
  const double on_head = glm::smoothstep(0.6, glm::mix(3.0, 4.6, back), row);
  const double on_chest = 0.55 * (1 - glm::smoothstep(0.0, 1.6, row));
  const double below_mouth = 1 - glm::smoothstep(mouth_line(place.x) - 0.003, mouth_line(place.x) + 0.0005, place.y);
  const double jaw = 0.65 * on_head * below_mouth * glm::smoothstep(0.0, 0.06, place.z) *
                     (1 - glm::smoothstep(0.030, 0.060, std::abs(place.x)));
  return mannequin::bind({{"upper_chest", on_chest},
                          {"neck", (1 - on_chest) * (1 - on_head)},
                          {"head", (1 - on_chest) * on_head * (1 - jaw)},
                          {"jaw", (1 - on_chest) * on_head * jaw}});
}

dvec3 face_paint(dvec3 p) {
  dvec3 paint(1);
  if (p.z < 0.02) return paint;
  const double blush = 0.5 * face_bump(p, 0.0430, 1.6440, 0.0160, 0.0130) +
                       0.6 * face_bump(p, 0.0, 1.6390, 0.0110, 0.0090) + 0.25 * face_bump(p, 0.0, 1.573, 0.016, 0.01);
  paint *= glm::mix(dvec3(1), dvec3(1.0, 0.86, 0.84), blush);
  const double lip = std::abs(p.x) < mouth_half_width ? 1 - glm::smoothstep(0.85, 1.2, std::abs(on_lips(p))) : 0;
  const dvec3 colour = on_lips(p) > 0 ? dvec3(0.82, 0.60, 0.57) : dvec3(0.91, 0.69, 0.66);
  paint *= glm::mix(dvec3(1), colour, lip * (1 - 0.5 * std::pow(std::abs(p.x) / mouth_half_width, 4.0)));
  const double line = std::exp(-std::pow((p.y - mouth_line(p.x)) / 0.0014, 2.0));
  if (std::abs(p.x) < mouth_half_width) paint *= glm::mix(dvec3(1), dvec3(0.50, 0.34, 0.33), line);
  paint *= glm::mix(dvec3(1), dvec3(0.45, 0.33, 0.31), face_bump(p, 0.0068, 1.6305, 0.0036, 0.0026));  // nostrils
  return paint;
}

}  // namespace throng::wardrobe
