#pragma once

#include <vector>

#include "assets/places/window.h"

namespace throng::places {

/// A storey of a front.
struct Storey {
  double foot = 0;  ///< y of its floor
  double height = 3;
  double sill = 0.9;  ///< above the floor
  WindowStyle window = {};
};

/// The upper storeys of a front at z = 0 from x = -width / 2: wall and windows.
struct Front {
  double width = 6;
  std::vector<double> windows = {};  ///< x of their middles
  std::vector<Storey> storeys = {};  ///< upwards, their windows equally wide
  double top = 12;                   ///< y where the wall ends
  Paint wall = {};
  std::uint32_t seed = 1;
};
void front_wall(MeshBuilder& builder, const Front& front, int lod);

/// A projecting course between storeys.
void band(MeshBuilder& builder, double x0, double x1, double y, double height, double out, const Paint& paint, int lod);
/// The cornice below a roof; its foot is at `y`. Returns how far it stands out.
double cornice(MeshBuilder& builder, double x0, double x1, double y, const Paint& paint, int lod, bool brackets);

/// A roof of two slopes with its ridge along X, over x0 to x1, from `front_z` to `back_z`.
struct Roof {
  double x0 = -3, x1 = 3;
  double front_z = 0.4, back_z = -8;
  double eaves = 12, ridge = 15;
  Paint tile = {};
  std::uint32_t seed = 1;
};
void gable_roof(MeshBuilder& builder, const Roof& roof, int lod, const Paint& party_wall);
/// A steep slope with a flat top behind it.
void mansard_roof(MeshBuilder& builder, const Roof& roof, int lod, const Paint& party_wall);
/// A window in the slope of a roof; its foot's middle at (x, y, z).
void dormer(MeshBuilder& builder, dvec3 at, double width, double height, double depth, const Paint& wall,
            const Paint& tile, int lod, std::uint32_t seed);
void chimney(MeshBuilder& builder, dvec3 at, double height, const Paint& paint, int lod);

/// Both side walls and the back wall of a bay, so that a row may end anywhere.
void closed_box(MeshBuilder& builder, double width, double foot, double top, double depth, const Paint& side,
                const Paint& back_wall);

/// A striped cloth over a shop, from (x0, y) to (x1, y), standing out by `out`.
void awning(MeshBuilder& builder, double x0, double x1, double y, double out, const Paint& one, const Paint& other,
            int stripes, int lod);
/// A shop's wooden front between x0 and x1, set back by `reveal` into a hole that its wall leaves.
void shop_front(MeshBuilder& builder, double x0, double x1, double foot, double height, double reveal,
                const Paint& wood, bool door_left, int lod, std::uint32_t seed);
/// The ground floor of a bay: two stone piers and a lintel around a shop front.
void ground_floor(MeshBuilder& builder, double height, const Paint& stone, const Paint& wood, bool door_left, int lod,
                  std::uint32_t seed);
/// A row of house-front stones: a pier of courses from x0 to x1.
void rusticated(MeshBuilder& builder, double x0, double x1, double y0, double y1, int courses, const Paint& paint,
                int lod, std::uint32_t seed);

}  // namespace throng::places
