#include "app/demo/placed_model.h"

#include "app/files/joined.h"

namespace throng::app {

void place_model(Show& show, const NewPlacement& asked, Messages& messages) {
  const auto seconds = show.set_placement(asked.character, asked.choice);
  if (!seconds) return messages.say(seconds.error().message, Message::Kind::refused);
  const CharacterSource& placed = show.stage().people()[asked.character];
  messages.say(placed.name + ": " + placed.placement.reasons + "; made anew in " + fixed(*seconds, 1) + " s");
}

}  // namespace throng::app
