#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/settings/tuning_values.h"
#include "engine/base/random.h"

namespace throng::soak {

template <typename Element>
const Element& any_of(Random& random, const std::vector<Element>& elements) {
  return elements[random.below(static_cast<std::uint32_t>(elements.size()))];
}

/// Draws a number from `least` to `most`, one of the two ends now and then, and small ones as often as large ones.
double any_number(Random& random, double least, double most);
/// Draws a whole number in the same way.
int any_whole_number(Random& random, int least, int most);

/// Returns a text that the reader of a value takes. Crowds, threads and stores stay small, so that a round is short.
std::string any_text_of(const app::TuningValue& value, Random& random);

/// Gives about a third of all values others.
void change_some_values(app::Tuning& tuning, Random& random);

}  // namespace throng::soak
