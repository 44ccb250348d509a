#include "app/character/files.h"

#include <utility>

#include "app/character/body_parts.h"
#include "app/character/bone_lod.h"
#include "app/character/built_in.h"
#include "app/character/role_table.h"
#include "app/files/data_folder.h"

namespace throng::app {

anim::Result<CharacterSource> load_built_in(const std::string& data_option, const LoadOptions& options) {
  const auto files = find_built_in(data_option, options.wardrobe);
  if (!files) return files.error();
  const auto rules = find_data(data_folders(data_option), "assets/cast.json");
  if (!rules) return rules.error();
  const BoneLodFile kept{{}};
  auto taken = take_built_in(*files, options);
  auto source = taken ? anim::Result<CharacterSource>(std::move(*taken)) : make_built_in(*files, options, &kept);
  if (!source) return source;
  source->cast_rules = rules->string();
  const auto rig = RoleFile({}).read_rig();
  if (!rig) return rig.error();
  if (rig->empty()) return source;
  const anim::Status rigged = take_rig(*source, *rig);
  if (!rigged) return anim::Error{"the rig kept for " + source->name + ": " + rigged.error().message};
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
