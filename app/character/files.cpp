#include "app/character/files.h"

#include <utility>

#include "app/character/body_parts.h"
#include "app/character/bone_lod.h"
#include "app/character/role_table.h"
#include "app/character/wardrobe_file.h"
#include "app/files/data_folder.h"

namespace throng::app {

namespace {

anim::Status take_wardrobe(CharacterSource& source, const std::string& data_option, const LoadOptions& options) {
  const std::vector<std::filesystem::path> folders = data_folders(data_option);
  const auto rules = find_data(folders, "assets/cast.json");
  if (!rules) return rules.error();
  source.cast_rules = rules->string();
  if (!options.wardrobe) return anim::Done{};
  const auto file = find_data(folders, "assets/wardrobe.glb");
  if (!file) return file.error();
  return add_parts(source, *file);
}

}  // namespace

anim::Result<CharacterSource> load_built_in(const std::string& data_option, const LoadOptions& options) {
  const auto file = find_data(data_folders(data_option), "assets/mannequin.glb");
  if (!file) return file.error();
  const BoneLodFile kept{{}};
  auto source = load_character(file->string(), "mannequin (built in)", &kept, options);
  if (!source) return source;
  if (const anim::Status dressed = take_wardrobe(*source, data_option, options); !dressed) return dressed.error();
  const auto rig = RoleFile({}).read_rig();
  if (!rig) return rig.error();
  if (rig->empty()) return source;
  const anim::Status taken = take_rig(*source, *rig);
  if (!taken) return anim::Error{"the rig kept for " + source->name + ": " + taken.error().message};
  return source;
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
