#include "app/show/kept_choices.h"

#include "app/character/bone_lod.h"
#include "app/character/lod_export.h"
#include "app/character/role_table.h"
#include "app/character/skin_choice.h"
#include "app/show/show.h"

namespace throng::app {

anim::Result<std::filesystem::path> save_roles(const CharacterSource& character) {
  return RoleFile(character.file).write(all_choices(character.roles.clips, character.clip_names));
}

// It counts for every character of the file, as it is read with the file.
anim::Result<std::filesystem::path> save_rig(const CharacterSource& character) {
  return RoleFile(character_file(character.file).path).write_rig(character.rig);
}

anim::Result<std::filesystem::path> save_bone_lod(const CharacterSource& character) {
  return BoneLodFile(character.file).write(character.character->skeleton);
}

anim::Result<std::filesystem::path> export_lod(const Show& show, std::size_t index) {
  const CharacterSource& character = show.stage().characters()[index];
  const auto levels = lod_levels(character);
  const auto height = static_cast<float>(show.height);
  const double pixels_per_unit = static_cast<double>(render::pixels_tall(show.camera, height, 1, 1));
  return KeptFile(character.file, ".lod.export.json", "The level of detail")
      .write(lod_as_json(character, levels, show.painter().mesh_levels(index), show.stage().tuning().lod,
                         pixels_per_unit));
}

}  // namespace throng::app
