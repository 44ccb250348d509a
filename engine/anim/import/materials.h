#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include <glm/mat3x3.hpp>

#include "engine/anim/asset/model.h"
#include "engine/anim/import/document.h"
#include "engine/anim/import/specular_glossiness.h"

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

  /// Returns the coordinates that a material's textures read, by anim::Texture::coords.
  std::span<const CoordsSource> coords(int material) const { return coords_[static_cast<std::size_t>(material)]; }

  std::vector<anim::Material> take_materials() { return std::move(materials_); }
  std::vector<anim::Image> take_images() { return std::move(images_); }

 private:
  anim::Material convert(const tinygltf::Material& source);
  void read_specular_glossiness(const tinygltf::Value& extension, anim::Material& material);
  void convert_images(const TextureReference& diffuse, const TextureReference& specular,
                      const SpecularGlossiness& factors, anim::Material& material);
  int index_of_converted(const anim::Image& diffuse, const anim::Image& specular, const SpecularGlossiness& factors);
  anim::Texture texture(const TextureReference& reference);
  anim::Texture placed(const TextureReference& reference);  // without its image
  int coords_index(const CoordsSource& source);
  void read_sampler(int sampler, anim::Texture& texture);
  std::optional<anim::Image> image_of(int texture);
  std::optional<anim::Image> image(int file_image);
  int index_of(const anim::Image& image);

  Document& document_;
  std::map<int, int> material_of_;                         ///< index in the file -> in the model
  std::map<int, std::optional<anim::Image>> read_images_;  ///< by index in the file, none for a dropped image
  /// Two images that were made of two others; the second has metallic and roughness and follows the base colour.
  struct ConvertedImages {
    const std::uint8_t* diffuse;  ///< pixels
    const std::uint8_t* specular;
    SpecularGlossiness factors;
    int base_color;
  };
  std::vector<ConvertedImages> converted_;
  std::vector<anim::Material> materials_;
  std::vector<std::vector<CoordsSource>> coords_;  ///< by material of the model
  std::vector<anim::Image> images_;
};

}  // namespace throng::import
