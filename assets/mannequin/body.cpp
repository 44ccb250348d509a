#include "assets/mannequin/body_parts.h"

namespace throng::mannequin {

Cage build_half_body() {
  Cage half;
  const TorsoBorders borders = add_torso(half);
  add_head(half, borders.neck);
  add_hand(half, add_arm(half, borders.armhole));
  add_shoe(half, add_leg(half, borders.leg));
  return half;
}

}  // namespace throng::mannequin
