#pragma once

#include <array>
#include <vector>

#include "engine/anim/asset/model.h"
#include "engine/anim/bake/character.h"

namespace throng::anim {

/// How far a clip's surface is off when only some of its frames are posed: metres at the point that is off most, of
/// which 99% of the clip's frames stay below. By the time from one posed frame to the next, in sixtieths of a second.
struct SkipError {
  static constexpr std::array<int, 4> spans{2, 4, 8, 16};

  /// Shown between two posed frames, on the straight line from one to the other (smooth skipping); grows about as the
  /// square of the span. Until measured: that of a person who walks.
  std::array<float, spans.size()> blended{0.0018F, 0.007F, 0.028F, 0.1F};
  /// Shown until the next posed frame, as it is.
  std::array<float, spans.size()> held{0.03F, 0.088F, 0.18F, 0.3F};

  /// At any span, along power laws between those measured; 0 at one sixtieth or less.
  float metres(float sixtieths, bool smooth) const;
};

/// What does not move at all.
inline constexpr SkipError no_skip_error{.blended = {}, .held = {}};

/// Of each clip of `character`, which `model` was baked to: on its joints and on the farthest vertex of each bone, root
/// motion left out, for stretches all over the clip.
std::vector<SkipError> measure_skip_errors(const Model& model, const Character& character);

}  // namespace throng::anim
