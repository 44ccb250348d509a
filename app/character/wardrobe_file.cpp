#include "app/character/wardrobe_file.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "app/character/material_data.h"
#include "engine/base/text/plain_text.h"

namespace throng::app {
namespace {

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

anim::Status add_parts(anim::Model& model, const std::string& character, const std::filesystem::path& file) {
  auto imported = import_to_draw(file.string());
  if (!imported) return imported.error();
  anim::Model& wardrobe = imported->models.front();
  const std::string name = plain_text(file.string());
  if (wardrobe.parts.empty()) {
    return anim::Error{name + ": it has no parts to wear; engine/anim/import/README.md says how a node becomes one"};
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
    return anim::Error{name + ": its joint " + in_quotes(wardrobe.skeleton.bones[bone].name) + " is none of " +
                       character + "; export it with the skeleton of that character"};
  }
  for (anim::Material& material : wardrobe.materials) move_images(material, first_image);
  std::ranges::move(wardrobe.materials, std::back_inserter(model.materials));
  std::ranges::move(wardrobe.images, std::back_inserter(model.images));
  std::ranges::move(wardrobe.parts, std::back_inserter(model.parts));
  return anim::Done{};
}

}  // namespace throng::app
