#include <cmath>

#include <glm/geometric.hpp>

#include "assets/wardrobe/clothes.h"
#include "assets/wardrobe/sewing.h"
#include "assets/wardrobe/tailor.h"

namespace throng::wardrobe {
namespace {

using glm::dvec3;
using mannequin::Skin;

/// A narrow band around the neck that is turned in.
void rib_neck(Cage& cage, const Row& neck, double trim) {
  const Row inner = moved(cage, neck, [](dvec3 p) { return dvec3(-p.x * 0.16, -0.006, p.z > -0.02 ? -0.009 : 0.009); });
  join(cage, neck, inner, false, Region::shirt, 0.82, trim);
}

/// A stand that folds over; its leaf ends in points in front.
std::vector<CollarPoint> shirt_collar(double angle) {
  const double front = rise(75, 5, angle);
  const double stand = 0.036 - 0.010 * front;
  const double leaf = 0.034 + 0.046 * front * front;
  const double flare = 0.010 * front;
  return {{0.000, -0.010},
          {0.005, stand},
          {0.013 + 0.3 * flare, stand},
          {0.021 + flare, stand - leaf},
          {0.012 + flare, stand - leaf + 0.004}};
}

constexpr TrunkRow shirt_neck{1.514, 0.069, 0.044, -0.081, 0.030, 0.0, 1.0};

std::vector<SleeveRow> long_sleeve(double room, double cuff) {
  return {{0.070, 0.058 + room, 0.057 + room, 0, -0.006, 0, 1, true},
          {0.172, 0.050 + room, 0.050 + room, 0, 0},
          {0.270, 0.046 + room, 0.045 + room, 0, 0.002},
          {0.300, 0.046 + room, 0.045 + room, 0, 0.002},
          {0.390, 0.042 + room, 0.041 + room, 0.002, 0},
          {0.482, 0.037 + room, 0.036 + room, 0.001, 0},
          {0.492, 0.033 + cuff, 0.030 + cuff, 0, 0, 1, 0.85},
          {0.540, 0.032 + cuff, 0.027 + cuff, 0, 0, 1}};
}

void placket(Skin& cloth, double high, double low, int buttons) {
  sew_on(cloth, {.rows = rectangle({-0.014, low}, {0.014, high}, 5, 1), .lift = 0.0030});
  add_buttons(cloth, Region::shirt, {0, high - 0.02}, {0, low + 0.05}, buttons, 0.0055, 0.0036, 0.85, 1);
}

}  // namespace

Skin make_t_shirt() {
  Cage half;
  const TopBorders top = add_top(half, {.rows = {{0.935, 0.177, 0.112, -0.146, 0.004},
                                                 {0.985, 0.170, 0.108, -0.136},
                                                 {1.065, 0.158, 0.110, -0.115},
                                                 {1.170, 0.158, 0.113, -0.114},
                                                 {1.280, 0.168, 0.121, -0.127, 0.006, 0, 0.84}}});
  rib_neck(half, top.neck, 1);
  add_sleeve(half, top.armhole, Region::shirt,
             {{0.070, 0.062, 0.061, 0, -0.006, 0, 1, true},
              {0.125, 0.059, 0.058, 0, -0.002, 1},
              {0.190, 0.055, 0.055, 0, 0, 1}});
  Skin cloth = mirrored_surface(half);
  crumple(cloth, 0.0020);
  return cloth;
}

Skin make_polo() {
  Cage half;
  const TopBorders top = add_top(half, {.rows = {{0.915, 0.180, 0.112, -0.148, 0.0, 0.012},
                                                 {0.975, 0.172, 0.110, -0.138},
                                                 {1.065, 0.160, 0.110, -0.114},
                                                 {1.170, 0.160, 0.113, -0.114},
                                                 {1.280, 0.168, 0.121, -0.127, 0.006, 0, 0.84}},
                                        .neck = shirt_neck});
  add_collar(half, Region::shirt, 10, 1, shirt_collar);
  add_sleeve(half, top.armhole, Region::shirt,
             {{0.070, 0.060, 0.059, 0, -0.006, 0, 1, true},
              {0.125, 0.058, 0.057, 0, -0.002},
              {0.165, 0.056, 0.056, 0, 0},
              {0.190, 0.055, 0.055, 0, 0, 1}});
  Skin cloth = mirrored_surface(half);
  crumple(cloth, 0.0018);
  placket(cloth, 1.470, 1.330, 2);
  return cloth;
}

Skin make_tank_top() {
  Cage half;
  const TopBorders top = add_top(half, {.rows = {{0.940, 0.176, 0.110, -0.144, 0.004},
                                                 {1.000, 0.169, 0.109, -0.132},
                                                 {1.065, 0.157, 0.109, -0.112},
                                                 {1.170, 0.158, 0.113, -0.114},
                                                 {1.280, 0.168, 0.121, -0.127, 0.006, 0, 0.84}},
                                        .ease = 0.007,
                                        .neck = {1.504, 0.088, 0.048, -0.092, 0.030, 0.0, 0.95},
                                        .slope_width = 0.116,
                                        .scoop = 0.060,
                                        .scoop_back = 0.030,
                                        .armhole_in = 0.024});
  rib_neck(half, top.neck, 1);
  hem_armhole(half, top.armhole, Region::shirt, 1);
  Skin cloth = mirrored_surface(half);
  append(cloth, bare_skin(Slot::torso, 1.335));
  return cloth;
}

Skin make_shirt() {
  Cage half;
  const TopBorders top = add_top(half, {.rows = {{0.900, 0.181, 0.114, -0.150, -0.004, 0.020},
                                                 {0.975, 0.172, 0.111, -0.138},
                                                 {1.065, 0.161, 0.110, -0.118},
                                                 {1.170, 0.160, 0.113, -0.116},
                                                 {1.280, 0.169, 0.121, -0.127, 0.006, 0, 0.84}},
                                        .neck = shirt_neck});
  add_collar(half, Region::shirt, 9, 1, shirt_collar);
  add_sleeve(half, top.armhole, Region::shirt, long_sleeve(0.002, 0.002));
  Skin cloth = mirrored_surface(half);
  crumple(cloth, 0.0024);
  placket(cloth, 1.474, 0.912, 7);
  sew_on(cloth, {.rows = rectangle({0.062, 1.270}, {0.118, 1.335}, 1, 2), .lift = 0.003});
  return cloth;
}

Skin make_blouse() {
  Cage half;
  const TopBorders top = add_top(half, {.rows = {{0.885, 0.188, 0.116, -0.151, 0.0, 0.004},
                                                 {0.935, 0.181, 0.115, -0.147},
                                                 {0.990, 0.170, 0.110, -0.135},
                                                 {1.060, 0.155, 0.106, -0.108},
                                                 {1.085, 0.155, 0.107, -0.108},
                                                 {1.170, 0.160, 0.116, -0.116},
                                                 {1.280, 0.170, 0.124, -0.128, 0.006, 0, 0.84}},
                                        .ease = 0.007,
                                        .neck = {1.506, 0.082, 0.048, -0.090, 0.030, 0.0, 0.9},
                                        .scoop = 0.014,
                                        .scoop_back = 0.004});
  rib_neck(half, top.neck, 1);
  add_sleeve(half, top.armhole, Region::shirt,
             {{0.065, 0.060, 0.059, 0, -0.005, 0, 1, true},
              {0.172, 0.051, 0.050, 0, 0},
              {0.280, 0.048, 0.046, 0, 0.001},
              {0.390, 0.045, 0.042, 0, 0.001},
              {0.480, 0.041, 0.037, 0, 0.001},
              {0.498, 0.034, 0.030, 0, 0, 0, 0.85},
              {0.530, 0.034, 0.030, 0, 0, 1}});
  Skin cloth = mirrored_surface(half);
  crumple(cloth, 0.0030);
  return cloth;
}

}  // namespace throng::wardrobe
