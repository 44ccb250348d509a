#include "app/character/built_in.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <map>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "app/character/body_parts.h"
#include "app/character/bone_lod.h"
#include "app/character/drawn_import.h"
#include "app/character/packed.h"
#include "app/character/role_table.h"
#include "app/files/data_folder.h"
#include "engine/base/files/free_memory.h"
#include "engine/base/text/plain_text.h"
#include "engine/render/mesh/packed_surface.h"

namespace throng::app {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t spaces_for_a_pack = 4;  // less address space: no pack, for half of it is copied

Result<std::uint64_t> fingerprint_of(const BuiltInFiles& files) {
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

constexpr std::uint16_t no_entry = UINT16_MAX;

/// Returns, for each palette entry of `from`, the entry of the bone with the same name in `to`.
std::vector<std::uint16_t> entries_in(const anim::Skeleton& from, const anim::Skeleton& to) {
  std::map<std::string, std::uint16_t> entries;
  for (std::size_t entry = 0; entry < to.palette.size(); ++entry) {
    entries.emplace(to.bones[static_cast<std::size_t>(to.palette[entry].bone)].name, static_cast<std::uint16_t>(entry));
  }
  std::vector<std::uint16_t> places;
  for (const anim::PaletteEntry& entry : from.palette) {
    const auto found = entries.find(from.bones[static_cast<std::size_t>(entry.bone)].name);
    places.push_back(found == entries.end() ? no_entry : found->second);
  }
  return places;
}

/// Lets a mesh read another palette and other materials. Returns the entry that has no place there, or -1.
int move_mesh(anim::SkinnedMesh& mesh, const std::vector<std::uint16_t>& entries, int first_material) {
  mesh.material += first_material;
  for (glm::u16vec4& influences : mesh.palette_entries) {
    for (glm::length_t i = 0; i < 4; ++i) {
      const std::uint16_t place = entries[influences[i]];
      if (place == no_entry) return influences[i];
      influences[i] = place;
    }
  }
  return -1;
}

void move_images(anim::Material& material, int first_image) {
  for (anim::Texture* texture :
       {&material.base_color_texture, &material.emission_texture, &material.metallic_roughness_texture,
        &material.normal_texture, &material.occlusion_texture}) {
    if (texture->image >= 0) texture->image += first_image;
  }
}

}  // namespace

Status add_parts(anim::Model& model, const std::string& character, const fs::path& file) {
  auto imported = import_to_draw(file.string());
  if (!imported) return imported.error();
  anim::Model& wardrobe = imported->models.front();
  const std::string name = plain_text(file.string());
  if (wardrobe.parts.empty()) {
    return Error{name + ": it has no parts to wear; engine/anim/import/README.md says how a node becomes one"};
  }
  const std::vector<std::uint16_t> entries = entries_in(wardrobe.skeleton, model.skeleton);
  const auto first_material = static_cast<int>(model.materials.size());
  const auto first_image = static_cast<int>(model.images.size());
  int unknown = -1;
  anim::visit_surfaces(wardrobe, [&](std::vector<anim::SkinnedMesh>& meshes) {
    for (anim::SkinnedMesh& mesh : meshes) unknown = std::max(unknown, move_mesh(mesh, entries, first_material));
  });
  if (unknown >= 0) {
    const auto bone = static_cast<std::size_t>(wardrobe.skeleton.palette[static_cast<std::size_t>(unknown)].bone);
    return Error{name + ": its joint " + in_quotes(wardrobe.skeleton.bones[bone].name) + " is none of " + character +
                 "; export it with the skeleton of that character"};
  }
  for (anim::Material& material : wardrobe.materials) move_images(material, first_image);
  std::ranges::move(wardrobe.materials, std::back_inserter(model.materials));
  std::ranges::move(wardrobe.images, std::back_inserter(model.images));
  std::ranges::move(wardrobe.parts, std::back_inserter(model.parts));
  return Done{};
}

Result<CharacterSource> load_built_in(const std::string& data_option, const LoadOptions& options) {
  const auto files = find_built_in(data_option, options.wardrobe);
  if (!files) return files.error();
  const auto rules = find_data(data_folders(data_option), "assets/cast.json");
  if (!rules) return rules.error();
  const BoneLodFile kept{{}};
  auto taken = take_built_in(*files, options);
  auto source = taken ? Result<CharacterSource>(std::move(*taken)) : make_built_in(*files, options, &kept);
  if (!source) return source;
  source->cast_rules = rules->string();
  const auto rig = RoleFile({}).read_rig();
  if (!rig) return rig.error();
  if (rig->empty()) return source;
  const Status rigged = take_rig(*source, *rig);
  if (!rigged) return Error{"the rig kept for " + source->name + ": " + rigged.error().message};
  return source;
}

Result<BuiltInFiles> find_built_in(const std::string& data_option, bool needs_wardrobe) {
  const std::vector<fs::path> folders = data_folders(data_option);
  const auto mannequin = find_data(folders, "assets/mannequin.glb");
  if (!mannequin) return mannequin.error();
  const auto wardrobe = find_data(folders, "assets/wardrobe.glb");
  if (!wardrobe && needs_wardrobe) return wardrobe.error();
  return BuiltInFiles{*mannequin, wardrobe ? *wardrobe : fs::path()};
}

Result<CharacterSource> make_built_in(const BuiltInFiles& files, const LoadOptions& options, const BoneLodFile* kept) {
  auto source = load_character(files.mannequin.string(), built_in_name, kept, options);
  if (!source || !options.wardrobe) return source;
  const Status dressed = add_parts(source->model, source->name, files.wardrobe);
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

Result<pack::FileToPack> built_in_to_pack(const BuiltInFiles& files) {
  const auto fingerprint = fingerprint_of(files);
  if (!fingerprint) return fingerprint.error();
  auto source = make_built_in(files, {.wardrobe = true});
  if (!source) return source.error();
  auto imported = import_to_draw(files.mannequin.string());
  if (!imported) return imported.error();
  Status dressed = add_parts(imported->models.front(), source->name, files.wardrobe);
  if (!dressed) return dressed.error();
  pack::FileToPack file{.name = "mannequin", .file = std::move(*imported), .characters = {}, .made_of = *fingerprint};
  file.with_keys = true;
  file.characters.push_back(
      {.name = source->cast.front(),
       .prepared = {std::move(source->placement), {}},
       .character = source->character,
       .surface = render::pack_surface(render::view_of(render::build_surface(mesh_data(*source))))});
  return file;
}

}  // namespace throng::app
