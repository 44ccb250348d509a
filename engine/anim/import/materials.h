#pragma once

#include <map>
#include <vector>

#include <glm/mat3x3.hpp>

#include "engine/anim/asset/model.h"
#include "engine/anim/import/document.h"

namespace throng::import {

/// Collects the materials and images that one model uses.
class MaterialCollector {
 public:
  explicit MaterialCollector(Document& document) : document_(document) {}

  /// Returns the model's index of a material of the file, or of a plain white one for -1.
  int material(int file_material);

  /// Returns what KHR_texture_transform does to texture coordinates of that material; the identity without it.
  glm::mat3 texture_transform(int file_material) const;

  std::vector<anim::Material> take_materials() { return std::move(materials_); }
  std::vector<anim::Image> take_images() { return std::move(images_); }

 private:
  anim::Material convert(const tinygltf::Material& source, int index);
  int image(int texture);

  Document& document_;
  std::map<int, int> material_of_;  ///< index in the file -> in the model
  std::map<int, int> image_of_;     ///< index in the file -> in the model, -1 for a dropped image
  std::vector<anim::Material> materials_;
  std::vector<anim::Image> images_;
};

}  // namespace throng::import
