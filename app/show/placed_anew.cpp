#include "app/show/placed_anew.h"

#include <utility>
#include <vector>

#include "app/character/cast_files.h"
#include "app/character/files.h"
#include "app/request/chosen_character.h"

namespace throng::app {
namespace {

anim::Result<CharacterSource> load_again(const ChosenCharacter& wanted, LoadOptions options, const std::string& data) {
  if (wanted.file.empty()) {
    options.placement = wanted.placement;
    options.clips_from = wanted.clip_files;
    auto built_in = load_built_in(data, options);
    if (!built_in) return built_in;
    const anim::Status seen = check_extent(*built_in, built_in->name);
    return seen ? std::move(built_in) : anim::Result<CharacterSource>(seen.error());
  }
  const std::vector<CastEntry> entries = entries_of({&wanted, 1});
  auto cast = load_cast(entries, options);
  if (!cast) return cast.error();
  return std::move(cast->characters.front());
}

}  // namespace

anim::Result<CharacterSource> placed_anew(const CharacterSource& character, const anim::PlacementChoice& choice,
                                          const LoadOptions& options, const std::string& data) {
  ChosenCharacter wanted = exactly(character);
  wanted.placement = choice;
  auto placed = load_again(wanted, options, data);
  if (!placed) return placed;
  placed->cast_rules = character.cast_rules;
  placed->rules_are_chosen = character.rules_are_chosen;
  const anim::Status became = become(wanted, *placed);
  if (!became) return became.error();
  return placed;
}

}  // namespace throng::app
