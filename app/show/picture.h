#pragma once

#include <cstdint>
#include <vector>

#include "engine/crowd/sorted_draws.h"

namespace throng::app {

class Stage;

/// The draws of a stage's agents in view, coloured as the stage's tuning says.
class Picture : public SortedDraws {
 public:
  /// Sorts the agents. Exact poses are drawn with their full meshes.
  void compose(const Stage& stage, Poses poses = Poses::shown);

 private:
  void color(const Stage& stage, Poses poses);
  void put_things_away(const Stage& stage);

  std::vector<std::uint32_t> colors_;    // [place in view]
  std::vector<std::uint16_t> put_away_;  // [place in view]
  std::vector<float> contact_scales_;    // [character]
};

}  // namespace throng::app
