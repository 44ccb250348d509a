#include "app/demo/placed_model.h"

#include "app/files/joined.h"

namespace throng::app {

std::string place_model(Show& show, const NewPlacement& asked) {
  const auto seconds = show.set_placement(asked.character, asked.choice);
  if (!seconds) return seconds.error().message;
  const CharacterSource& placed = show.stage().people()[asked.character];
  return placed.name + ": " + placed.placement.reasons + "; made anew in " + fixed(*seconds, 1) + " s";
}

}  // namespace throng::app
