#pragma once

#include <glm/vec2.hpp>

namespace throng::app {

/// The width of the word THRONG over the height of its letters.
inline constexpr double word_width = 6.12;

/// Returns how far a point is from the middle of the nearest stroke of the word, as a share of the height of its
/// letters. The word begins at x 0 and stands on y 0; its letters are 1 high.
double distance_to_word(glm::dvec2 at);

}  // namespace throng::app
