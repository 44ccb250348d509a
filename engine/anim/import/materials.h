#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>

#include "engine/anim/asset/model.h"
#include "engine/anim/import/document.h"

namespace throng::import {

/// Names the source of a texture's coordinates: the attribute TEXCOORD_`set`, moved by `transform`.
struct CoordsSource {
  int set = 0;
  glm::mat3 transform{1.0F};

  bool operator==(const CoordsSource&) const = default;
};

struct TextureReference;

/// Collects the materials and images that one model uses.
class MaterialCollector {
 public:
  explicit MaterialCollector(Document& document) : document_(document) {}

  /// Returns the model's index of a material of the file, or of a plain white one for -1.
  int material(int file_material);

  const anim::Material& at(int material) const { return materials_[static_cast<std::size_t>(material)]; }

  /// Returns what the textures of a material of the model read, by anim::Texture::coords.
  std::span<const CoordsSource> coords(int material) const { return coords_[static_cast<std::size_t>(material)]; }

  std::vector<anim::Material> take_materials() { return std::move(materials_); }
  std::vector<anim::Image> take_images() { return std::move(images_); }

 private:
  anim::Material convert(const tinygltf::Material& source);
  void read_specular_glossiness(const tinygltf::Value& extension, anim::Material& material);
  anim::Texture texture(const TextureReference& reference);
  int coords_index(const CoordsSource& source);
  void read_sampler(int sampler, anim::Texture& texture);
  int image_of_texture(int texture);
  int image(int file_image);

  Document& document_;
  std::map<int, int> material_of_;  ///< index in the file -> in the model
  std::map<int, int> image_of_;     ///< index in the file -> in the model, -1 for a dropped image
  std::vector<anim::Material> materials_;
  std::vector<std::vector<CoordsSource>> coords_;  ///< by material of the model
  std::vector<anim::Image> images_;
};

}  // namespace throng::import
