#include "app/character/files.h"

#include <utility>

#include "app/character/bone_lod.h"
#include "app/character/clip_files.h"
#include "app/character/role_table.h"
#include "app/files/data_folder.h"

namespace throng::app {

anim::Result<std::vector<CharacterSource>> load_characters(std::span<const std::string> files,
                                                           std::span<const std::string> clips_from) {
  std::vector<CharacterSource> characters;
  for (const std::string& file : files) {
    const BoneLodFile kept(file);
    auto character = load_character(file, file, &kept, clips_from);
    if (!character) return character.error();
    characters.push_back(std::move(*character));
    characters.back().file = file;
  }
  return characters;
}

anim::Result<std::vector<CharacterSource>> load_dropped(std::span<const std::string> files) {
  std::vector<std::string> models, clips;
  for (const std::string& file : files) (has_clips_alone(file) ? clips : models).push_back(file);
  return models.empty() ? load_characters(files) : load_characters(models, clips);
}

anim::Result<CharacterSource> load_built_in(const std::string& data_option, std::span<const std::string> clips_from) {
  const auto file = find_data(data_folders(data_option), "assets/mannequin.glb");
  if (!file) return file.error();
  const BoneLodFile kept{{}};
  return load_character(file->string(), "mannequin (built in)", &kept, clips_from);
}

anim::Status take_kept_roles(CharacterSource& character) {
  const auto kept = RoleFile(character.file).read();
  if (!kept) return kept.error();
  RoleClips clips = character.roles.clips;
  if (const auto chosen = choose_clips(*kept, character.clip_names, clips); !chosen) {
    return anim::Error{"the roles kept for " + character.name + ": " + chosen.error().message};
  }
  assign_roles(character, clips);
  return anim::Done{};
}

}  // namespace throng::app
