#include "app/character/model_placement.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "app/character/skin_choice.h"
#include "engine/base/text/joined.h"
#include "engine/base/text/plain_text.h"

namespace throng::app {
namespace {

bool is_called(const std::string& file, const std::string& name) {
  const CharacterFile wanted = character_file(file);
  const std::filesystem::path path(wanted.path);
  return path.filename() == name || path.stem() == name || (!wanted.skin.empty() && wanted.skin == name);
}

const char* option_of(const ModelPlacement& placement) {
  return placement.scale ? "--scale" : placement.up ? "--up" : "--ground";
}

}  // namespace

anim::PlacementChoice placement_for(const std::string& file, const LoadOptions& options) {
  anim::PlacementChoice choice = options.placement;
  for (const ModelPlacement& asked : options.placements) {
    if (!is_called(file, asked.model)) continue;
    if (asked.scale) choice.scale = asked.scale;
    choice.up = asked.up.value_or(choice.up);
    choice.ground = asked.ground.value_or(choice.ground);
  }
  return choice;
}

Status check_placed_models(std::span<const ModelPlacement> placements, std::span<const CharacterSource> characters) {
  for (const ModelPlacement& asked : placements) {
    const auto is_meant = [&](const CharacterSource& character) { return is_called(character.file, asked.model); };
    if (std::ranges::any_of(characters, is_meant)) continue;
    std::set<std::string> names;
    for (const CharacterSource& character : characters) {
      const std::filesystem::path path(character_file(character.file).path);
      names.insert(character.file.empty() ? character.name : plain_text(path.filename().string()));
    }
    return Error{std::string(option_of(asked)) + ": no model is called " + plain_text(asked.model) + "; there is " +
                 joined(std::vector<std::string>(names.begin(), names.end()), ", ", " and ")};
  }
  return Done{};
}

}  // namespace throng::app
