#pragma once

#include <functional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "assets/mannequin/cage.h"
#include "assets/wardrobe/make.h"

namespace throng::wardrobe {

// Clothes are cut in rows of vertices around the left half of the man, from the front to the back.

using Row = std::vector<std::size_t>;
using mannequin::Cage;
using mannequin::Region;

/// A horizontal cross-section of cloth around the trunk or both legs, metres.
struct TrunkRow {
  double height, half_width, front, back;
  double drop_front = 0;  ///< How far the front of the row lies below its sides.
  double drop_back = 0;
  double squareness = 0.88;  ///< 1 is an ellipse; smaller is more of a box.
};

/// Round the trunk at a height of the man himself, `ease` metres outside his skin.
TrunkRow trunk_row(double height, double ease);

/// Describes the cut of a garment for the trunk.
struct TopCut {
  Region region = Region::shirt;
  std::vector<TrunkRow> rows = {};  ///< From the hem to the breast.
  double ease = 0.006;              ///< Above the breast, outside the skin.
  double shoulder = 0;              ///< Makes the shoulders wider.
  TrunkRow neck{1.514, 0.071, 0.046, -0.083, 0.030, 0.0, 1.0};
  double slope_width = 0.112;  ///< Half the width of the row between neck and shoulder.
  double scoop = 0;            ///< How much deeper the neck is in front than a collar's.
  double scoop_back = 0;
  double armhole_in = 0;                          ///< Moves the armhole towards the neck, for straps.
  double hem_depth = 0.012;                       ///< How far the hem is turned in, upwards.
  std::function<double(double height)> gap = {};  ///< Half the opening in front; none is closed.
  bool dense = false;   ///< More columns in front and behind, for what hangs down to the knee.
  double hem_trim = 0;  ///< Of the band between the first two rows.
};

struct TopBorders {
  Row neck;
  Row armhole;            ///< Eight vertices from below over the back to the top and the front.
  std::vector<Row> rows;  ///< From the hem to the neck.
};
TopBorders add_top(Cage& cage, const TopCut& cut);
/// A row around trunk or legs alone, from the front to the back.
Row add_trunk_row(Cage& cage, const TrunkRow& row, bool dense);

/// The inside of what hangs from the hips, from the hem up to a height, a little narrower.
void line_below(Cage& cage, const TopCut& cut, double top);

/// A cross-section of a sleeve: along the arm from the shoulder joint, its half sizes, and how far its middle lies
/// towards the thumb and outwards.
struct SleeveRow {
  double along, half_width, half_height;
  double thumb = 0, out = 0;
  double trim = 0;      ///< Of the band between this row and the one before.
  double paint = 1;     ///< Of the same band.
  bool smooth = false;  ///< The band is divided along the arm as well.
};
Row add_sleeve(Cage& cage, const Row& armhole, Region region, const std::vector<SleeveRow>& rows,
               double turned_in = 0.010);
/// The border of a garment without sleeves.
void hem_armhole(Cage& cage, const Row& armhole, Region region, double trim = 0);

/// A copy of a row, each vertex moved; one on the plane x = 0 stays on it.
Row moved(Cage& cage, const Row& row, const std::function<glm::dvec3(glm::dvec3 place)>& step);
/// Quads between rows with the cage's present notes; `straight` halves them only.
void join(Cage& cage, const Row& lower, const Row& upper, bool closed, Region region, double paint, double trim,
          bool straight = true);

/// Turns the lower edge of cloth in: a band of its own, so that the edge is sharp.
void turn_in(Cage& cage, const Row& edge, bool closed, Region region, double trim,
             const std::function<glm::dvec3(glm::dvec3 place)>& step);

/// Around the neck, out of its skin by `out` and up from the collar's seam.
struct CollarPoint {
  double out, up;
};
/// Rows around the neck from the angle `from` (degrees, 0 in front) to the back; `profile` says of an angle where its
/// points lie, from inside the neck over the top to the outside.
void add_collar(Cage& cage, Region region, double from, double trim,
                const std::function<std::vector<CollarPoint>(double angle)>& profile);

/// Weights of what hangs from the hips: like the skin above them; further down like both thighs, left and right blend.
mannequin::Weights hanging_weights(glm::dvec3 place);

/// Goes from 0 to 1.
double rise(double from, double to, double value);

}  // namespace throng::wardrobe
