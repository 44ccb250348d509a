#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <vector>

#include "throng/render/crowd_mesh_data.h"

#include "engine/base/result.h"
#include "engine/render/gl/handles.h"
#include "engine/render/mesh/coverage.h"

namespace throng::render {

/// Names an image on the device, and how it is read.
struct CrowdTexture {
  GLuint image;  ///< plain white where the character brings none
  GLuint sampler;
};

/// One material on the device.
struct CrowdMaterial {
  float base_color[4];  ///< linear
  CrowdTexture base_color_texture;
  float emission[3];  ///< linear
  CrowdTexture emission_texture;
  CrowdTexture metallic_roughness_texture;
  CrowdTexture normal_texture;
  CrowdTexture occlusion_texture;
  float factors[4];  ///< metallic, roughness, scale of the normal texture, strength of occlusion; 0: no such texture
  bool is_textured;  ///< its base colour has a texture
  bool is_plain;     ///< its base colour is all that light needs to know, and nothing shines by itself
  bool unlit;
  bool double_sided;
  Coverage coverage;
  float alpha_cutoff;  ///< of a cut-out
};

/// Holds a character's materials on the device, with the images that they show.
class MaterialSet {
 public:
  MaterialSet() = default;

  /// Errors: an image is larger than the device takes.
  static Result<MaterialSet> create(const CrowdMeshData& data);

  int size() const { return static_cast<int>(materials_.size()); }
  const CrowdMaterial& operator[](int index) const { return materials_[static_cast<std::size_t>(index)]; }

 private:
  /// By index of the image; without a name where no material needs it.
  using Images = std::vector<gl::Texture>;

  Status add_images(const CrowdMeshData& data);
  CrowdTexture texture(const TextureData& data, const Images& images);
  GLuint sampler(const TextureData& data);

  Images colors_;   // decoded as sRGB
  Images numbers_;  // the same images, where a material reads them as they are
  gl::Texture white_;
  std::map<std::array<int, 4>, gl::Sampler> samplers_;  // by wraps and filters
  std::vector<CrowdMaterial> materials_;
};

}  // namespace throng::render
