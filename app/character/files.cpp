#include "app/character/files.h"

#include <utility>

#include "app/character/bone_lod.h"
#include "app/character/clip_files.h"
#include "app/character/packed.h"
#include "app/character/role_table.h"
#include "app/character/skin_choice.h"
#include "app/files/data_folder.h"
#include "app/files/joined.h"

namespace throng::app {
namespace {

// A pack stands for the first character of each file in it.
void add_packed(const pack::Pack& pack, const CharacterFile& wanted, std::vector<std::string>& every_file) {
  const std::vector<std::string> names = packed_names(pack, wanted.skin == all_skins);
  if (names.size() == 1) return every_file.push_back(wanted.path);
  for (const std::string& name : names) every_file.push_back(with_skin(wanted.path, name));
}

// A file all of whose characters are cast stands once for each of them.
anim::Result<std::vector<std::string>> each_character(std::span<const std::string> files,
                                                      const import::ImportOptions& options) {
  std::vector<std::string> every_file;
  for (const std::string& file : files) {
    const CharacterFile wanted = character_file(file);
    if (pack::is_pack(wanted.path) && (wanted.skin.empty() || wanted.skin == all_skins)) {
      const auto pack = pack::Pack::open(wanted.path);
      if (!pack) return pack.error();
      add_packed(*pack, wanted, every_file);
      continue;
    }
    if (wanted.skin != all_skins) {
      every_file.push_back(file);
      continue;
    }
    const auto imported = import::import_file(wanted.path, options);
    if (!imported) return imported.error();
    for (const std::string& name : character_names(*imported)) every_file.push_back(with_skin(wanted.path, name));
    if (every_file.empty()) every_file.push_back(wanted.path);  // which is then refused in words
  }
  return every_file;
}

anim::Status check_can_be_seen(const CharacterSource& character, const std::string& path) {
  if (!character.has_surface()) {
    const std::size_t clips = character.model.clips.size();
    return anim::Error{path + ": it has a skeleton of " + counted(character.model.skeleton.bones.size(), "bone") +
                       (clips > 0 ? " and " + counted(clips, "clip") : "") +
                       ", but no mesh to draw; open the file that has the mesh" +
                       (clips > 0 ? ", with --clips-from and this file" : ", or export both into one")};
  }
  constexpr double least = 1e-9, most = 1e9;  // metres, by which agents are spaced and cameras placed
  const auto is_sensible = [&](double length) { return length > least && length < most; };
  if (is_sensible(character.character->bounds.height) && is_sensible(character.character->bounds.reach)) {
    return anim::Done{};
  }
  return anim::Error{path +
                     ": its mesh has no height, or one beyond all measure, so it cannot be shown; export it again"};
}

}  // namespace

anim::Result<std::vector<CharacterSource>> load_characters(std::span<const std::string> files,
                                                           const LoadOptions& options) {
  const auto every_file = each_character(files, options.import);
  if (!every_file) return every_file.error();
  std::vector<CharacterSource> characters;
  for (const std::string& file : *every_file) {
    const BoneLodFile kept(file);
    auto character = load_character(file, file, &kept, options);
    if (!character) return character.error();
    if (const anim::Status seen = check_can_be_seen(*character, character_file(file).path); !seen) return seen.error();
    characters.push_back(std::move(*character));
    characters.back().file = file;
  }
  return characters;
}

anim::Result<std::vector<CharacterSource>> load_dropped(std::span<const std::string> files,
                                                        const LoadOptions& options) {
  std::vector<std::string> models;
  LoadOptions with_clips = options;
  for (const std::string& file : files) {
    const bool gives_clips = files.size() > 1 && has_clips_alone(file);
    (gives_clips ? with_clips.clips_from : models).push_back(file);
  }
  return models.empty() ? load_characters(files, options) : load_characters(models, with_clips);
}

anim::Result<CharacterSource> load_built_in(const std::string& data_option, const LoadOptions& options) {
  const auto file = find_data(data_folders(data_option), "assets/mannequin.glb");
  if (!file) return file.error();
  const BoneLodFile kept{{}};
  return load_character(file->string(), "mannequin (built in)", &kept, options);
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
