#include "app/show/placed_anew.h"

#include <utility>

#include "app/show/opened_crowd.h"

namespace throng::app {

anim::Result<CharacterSource> placed_anew(const CharacterSource& character, const anim::PlacementChoice& choice,
                                          const LoadOptions& options, const std::string& data) {
  ChosenCharacter wanted = exactly(character);
  wanted.placement = choice;
  auto cast = load_crowd({&wanted, 1}, data, options);
  if (!cast) return cast.error();
  CharacterSource placed = std::move(cast->characters.front());
  placed.cast_rules = character.cast_rules;
  placed.rules_are_chosen = character.rules_are_chosen;  // another size chooses no rules
  return placed;
}

}  // namespace throng::app
