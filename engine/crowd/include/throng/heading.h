#pragma once

namespace throng {

/// A direction on the ground: the character's forward is (sine, cosine) in x, z; cosine 1 faces +Z.
struct Heading {
  float cosine = 1.0F;
  float sine = 0.0F;
};

}  // namespace throng
