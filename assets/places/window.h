#pragma once

#include "assets/places/shapes.h"

namespace throng::places {

/// How the windows of a storey look.
struct WindowStyle {
  enum class Head { plain, lintel, pediment, round } head = Head::lintel;
  double width = 1.1;
  double height = 1.9;
  double reveal = 0.22;  ///< metres from the wall to the frame
  int columns = 2;
  int rows = 3;
  Paint trim = {};  ///< of sill and surround
  Paint frame = {};
  bool surround = true;
  bool shutters = false;
  Paint shutter = {};
  bool railing = false;  ///< a small balcony before it
  bool flowers = false;  ///< a box of flowers on the sill
};

/// Puts a window with its foot's middle at (x, y) into the wall at z = 0; `seed` chooses whether it is lit.
/// The wall leaves a hole for it where window_is_hole() says so.
void window(MeshBuilder& builder, double x, double y, const WindowStyle& style, int lod, std::uint32_t seed);

inline bool window_is_hole(int lod) { return lod <= 1; }

}  // namespace throng::places
