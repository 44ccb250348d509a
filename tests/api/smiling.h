#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "engine/anim/api/character_data.h"
#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/bake/character.h"

namespace throng::api_test {

/// A triangle on the first of two bones. Its clip opens a smile within a second. Its material has all that a view
/// shows.
inline Character smiling() {
  anim::Model model = anim::synthetic_model(2, 1);
  anim::SkinnedMesh& mesh = model.meshes.emplace_back();
  for (int vertex = 0; vertex < 3; ++vertex) {
    mesh.positions.emplace_back(vertex, 0.0F, 0.0F);
    mesh.normals.emplace_back(0.0F, 0.0F, 1.0F);
    mesh.tangents.emplace_back(1.0F, 0.0F, 0.0F, -1.0F);
    mesh.colors.emplace_back(1.0F, 0.5F, 0.25F, 1.0F);
    mesh.palette_entries.emplace_back(0, 0, 0, 0);
    mesh.weights.emplace_back(1.0F, 0.0F, 0.0F, 0.0F);
    mesh.indices.push_back(static_cast<std::uint32_t>(vertex));
  }
  mesh.texture_coords = {{{0.0F, 0.0F}, {0.1F, 0.0F}, {0.2F, 0.0F}}, {{0.5F, 0.0F}, {0.6F, 0.0F}, {0.7F, 0.0F}}};
  mesh.morph_deltas = {{.vertex = 2, .morph = 0, .position = {0.0F, 0.5F, 0.0F}, .normal = {0.0F, 1.0F, 0.0F}}};
  model.morphs = {{.name = "smile"}};
  model.clips[0].morph_tracks = {{.morphs = {0}, .times = {0.0F, 1.0F}, .weights = {0.0F, 1.0F}}};
  static constexpr std::array<std::uint8_t, 8> texels{1, 2, 3, 4, 5, 6, 7, 8};
  model.images = {{.width = 1, .height = 1, .rgba = std::span(texels).first(4)},
                  {.width = 1, .height = 1, .rgba = std::span(texels).last(4)}};
  anim::Material& material = model.materials.emplace_back();
  material.base_color_texture = {.image = 0, .coords = 1};
  material.normal_texture = {.image = 1, .coords = 0};
  material.normal_scale = 0.5F;
  material.metallic = 0.25F;
  material.roughness = 0.75F;
  material.emission = {0.0F, 1.0F, 2.0F};
  material.alpha_cutoff = 0.4F;
  material.double_sided = true;
  anim::Character baked = anim::bake_character(model);
  LoadOptions options;
  options.keep_meshes = true;
  LoadedFile file;
  detail::add_character(std::move(model), {}, std::move(baked), options, file);
  return file.characters.front();
}

}  // namespace throng::api_test
