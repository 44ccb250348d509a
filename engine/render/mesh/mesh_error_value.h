#pragma once

namespace throng::render {

/// How far a coarser mesh is off, in metres, as MeshErrorMeter measures it.
struct MeshError {
  float surface = 0.0F;  ///< anywhere
  float face = 0.0F;     ///< on faces alone; the same where no face is known

  friend bool operator==(const MeshError&, const MeshError&) = default;
};

}  // namespace throng::render
