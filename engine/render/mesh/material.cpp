#include "engine/render/mesh/material.h"

#include <algorithm>
#include <bit>
#include <string>
#include <utility>

#include "engine/render/gl/device_limits.h"

namespace throng::render {
namespace {

gl::Texture create_image(const ImageData& image) {
  const auto mip_levels =
      static_cast<GLsizei>(std::bit_width(static_cast<unsigned>(std::max(image.width, image.height))));
  gl::Texture texture = gl::create_texture(GL_SRGB8_ALPHA8, image.width, image.height, mip_levels);
  const GLuint id = texture.id();
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(id, 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  glGenerateTextureMipmap(id);
  return texture;
}

gl::Texture create_white() {
  constexpr std::array<std::uint8_t, 4> white = {255, 255, 255, 255};
  return create_image({1, 1, white});
}

Status check_size(const ImageData& image, std::size_t index) {
  const int limit = gl::ask_device_limits().texture;
  if (image.width <= limit && image.height <= limit) return Done{};
  return Error{"image " + std::to_string(index) + " is " + std::to_string(image.width) + "x" +
               std::to_string(image.height) + "; this device takes " + std::to_string(limit) + ", scale it down"};
}

bool is_shown(int image, const CrowdMeshData& data) {
  return std::ranges::any_of(data.materials, [image](const MaterialData& material) {
    return material.base_color_texture.image == image || material.emission_texture.image == image;
  });
}

}  // namespace

Result<MaterialSet> MaterialSet::create(const CrowdMeshData& data) {
  MaterialSet set;
  if (const Status added = set.add_images(data); !added) return added.error();
  for (const MaterialData& material : data.materials) {
    const float* color = material.base_color;
    const float* emission = material.emission;
    set.materials_.push_back({.base_color = {color[0], color[1], color[2], color[3]},
                              .base_color_texture = set.texture(material.base_color_texture),
                              .emission = {emission[0], emission[1], emission[2]},
                              .emission_texture = set.texture(material.emission_texture),
                              .unlit = material.unlit,
                              .double_sided = material.double_sided,
                              .coverage = coverage_of(data, static_cast<int>(set.materials_.size())),
                              .alpha_cutoff = material.alpha_cutoff});
  }
  return set;
}

Status MaterialSet::add_images(const CrowdMeshData& data) {
  for (std::size_t i = 0; i < data.images.size(); ++i) {
    gl::Texture& texture = images_.emplace_back();
    if (!is_shown(static_cast<int>(i), data)) continue;
    if (Status fits = check_size(data.images[i], i); !fits) return fits;
    texture = create_image(data.images[i]);
  }
  images_.push_back(create_white());
  return Done{};
}

CrowdTexture MaterialSet::texture(const TextureData& data) {
  const gl::Texture& image = data.image < 0 ? images_.back() : images_[static_cast<std::size_t>(data.image)];
  return {image.id(), sampler(data)};
}

GLuint MaterialSet::sampler(const TextureData& data) {
  gl::Sampler& sampler = samplers_[{data.wrap_u, data.wrap_v, data.magnified, data.minified}];
  if (sampler) return sampler.id();
  sampler = gl::create_sampler();
  glSamplerParameteri(sampler.id(), GL_TEXTURE_WRAP_S, data.wrap_u);
  glSamplerParameteri(sampler.id(), GL_TEXTURE_WRAP_T, data.wrap_v);
  glSamplerParameteri(sampler.id(), GL_TEXTURE_MAG_FILTER, data.magnified);
  glSamplerParameteri(sampler.id(), GL_TEXTURE_MIN_FILTER, data.minified);
  return sampler.id();
}

}  // namespace throng::render
