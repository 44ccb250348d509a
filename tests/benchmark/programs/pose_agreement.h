#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "app/commands/bench/crowd.h"
#include "engine/anim/asset/model.h"

namespace throng::app {

/// Compares the palettes that one subject writes with those that another one wrote to the same memory, on the surface
/// of the first thousand agents.
class PoseAgreement {
 public:
  /// Keeps the palettes as they are now, unless the skeleton has scale: then there is nothing to compare.
  PoseAgreement(const anim::Model& model, const BenchPalettes& palettes, std::size_t agents);
  /// Returns how far, in metres, the palettes of now carry any joint or vertex of an agent away from where the kept
  /// ones did. One agent in ten may be farther off: between two clips that turn a bone half a turn apart, either
  /// way round is right.
  double off_by() const;

 private:
  double off_by(std::size_t agent) const;

  struct Point {
    std::size_t bone;
    glm::dvec3 place;  // in the bind pose
  };
  std::vector<Point> points_;
  const BenchPalettes* palettes_;
  std::vector<std::vector<anim::PaletteMatrix>> kept_;  // [agent][bone]
};

}  // namespace throng::app
