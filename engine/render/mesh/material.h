#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <vector>

#include "engine/render/crowd_mesh_data.h"
#include "engine/render/gl/handles.h"
#include "engine/render/mesh/coverage.h"
#include "engine/result.h"

namespace throng::render {

/// Names an image on the device, and how it is read.
struct CrowdTexture {
  GLuint image;  ///< sRGB; plain white where the character brings none
  GLuint sampler;
};

/// One material on the device.
struct CrowdMaterial {
  float base_color[4];  ///< linear
  CrowdTexture base_color_texture;
  float emission[3];  ///< linear
  CrowdTexture emission_texture;
  bool unlit;
  bool double_sided;
  Coverage coverage;
  float alpha_cutoff;  ///< of a cut-out

  /// Says whether light is all that it needs, and nothing shines by itself.
  bool only_reflects() const { return !unlit && emission[0] == 0.0F && emission[1] == 0.0F && emission[2] == 0.0F; }
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
  Status add_images(const CrowdMeshData& data);
  CrowdTexture texture(const TextureData& data);
  GLuint sampler(const TextureData& data);

  std::vector<gl::Texture> images_;  // without a name where no material shows the image; the last is white
  std::map<std::array<int, 4>, gl::Sampler> samplers_;  // by wraps and filters
  std::vector<CrowdMaterial> materials_;
};

}  // namespace throng::render
