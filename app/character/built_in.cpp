#include "app/character/built_in.h"

#include <array>
#include <cstdint>
#include <system_error>
#include <utility>

#include "app/character/bone_lod.h"
#include "app/character/material_data.h"
#include "app/character/packed.h"
#include "app/character/wardrobe_file.h"
#include "app/files/data_folder.h"
#include "engine/base/files/free_memory.h"
#include "engine/render/mesh/packed_surface.h"

namespace throng::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* built_in_name = "mannequin (built in)";
constexpr std::uintmax_t spaces_for_a_pack = 4;  // less address space: no pack, for half of it is copied

anim::Result<std::uint64_t> fingerprint_of(const BuiltInFiles& files) {
  const std::array paths{files.mannequin.string(), files.wardrobe.string()};
  return pack::fingerprint_of(paths);
}

/// Opens the pack beside the program, or the one that was installed with the files.
std::optional<pack::Pack> open_pack(const BuiltInFiles& files) {
  for (const fs::path& folder : {program_folder(), files.mannequin.parent_path()}) {
    std::error_code error;
    const fs::path path = folder / built_in_pack_name;
    const std::uintmax_t bytes = fs::file_size(path, error);
    if (error || bytes > free_address_space() / spaces_for_a_pack) continue;
    auto pack = pack::Pack::open(path.string());
    const auto fingerprint = fingerprint_of(files);
    if (pack && fingerprint && pack->made_of(0) == *fingerprint) return std::move(*pack);
  }
  return {};
}

}  // namespace

anim::Result<BuiltInFiles> find_built_in(const std::string& data_option, bool needs_wardrobe) {
  const std::vector<fs::path> folders = data_folders(data_option);
  const auto mannequin = find_data(folders, "assets/mannequin.glb");
  if (!mannequin) return mannequin.error();
  const auto wardrobe = find_data(folders, "assets/wardrobe.glb");
  if (!wardrobe && needs_wardrobe) return wardrobe.error();
  return BuiltInFiles{*mannequin, wardrobe ? *wardrobe : fs::path()};
}

anim::Result<CharacterSource> make_built_in(const BuiltInFiles& files, const LoadOptions& options,
                                            const BoneLodFile* kept) {
  auto source = load_character(files.mannequin.string(), built_in_name, kept, options);
  if (!source || !options.wardrobe) return source;
  const anim::Status dressed = add_parts(source->model, source->name, files.wardrobe);
  if (!dressed) return dressed.error();
  return source;
}

std::optional<CharacterSource> take_built_in(const BuiltInFiles& files, const LoadOptions& options) {
  if (options.placement != anim::PlacementChoice{} || !options.clips_from.empty()) return {};
  const auto pack = open_pack(files);
  if (!pack) return {};
  const BoneLodFile kept{{}};
  auto source = take_packed(*pack, {.path = files.mannequin.string(), .skin = {}}, built_in_name, &kept, options);
  if (!source) return {};
  if (!options.wardrobe) source->model.parts.clear();
  return std::move(*source);
}

anim::Result<pack::FileToPack> built_in_to_pack(const BuiltInFiles& files) {
  const auto fingerprint = fingerprint_of(files);
  if (!fingerprint) return fingerprint.error();
  auto source = make_built_in(files, {.wardrobe = true});
  if (!source) return source.error();
  auto imported = import_to_draw(files.mannequin.string());
  if (!imported) return imported.error();
  anim::Status dressed = add_parts(imported->models.front(), source->name, files.wardrobe);
  if (!dressed) return dressed.error();
  pack::FileToPack file{.name = "mannequin", .file = std::move(*imported), .characters = {}, .made_of = *fingerprint};
  file.characters.push_back(
      {.name = source->cast.front(),
       .prepared = {std::move(source->placement), {}},
       .character = source->character,
       .surface = render::pack_surface(render::view_of(render::build_surface(mesh_data(*source))))});
  return file;
}

}  // namespace throng::app
