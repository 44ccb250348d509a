#include "engine/render/mesh/material.h"

#include <algorithm>
#include <string>

#include "engine/render/gl/device_limits.h"
#include "engine/render/mesh/mip_levels.h"

namespace throng::render {
namespace {

// A rougher surface that is no metal mirrors too little to be seen.
constexpr float matt = 0.8F;

gl::Texture create_image(const ImageData& image, ImageKind kind) {
  const auto levels = mip_levels(image, kind);
  const GLenum format = kind == ImageKind::colors ? GL_SRGB8_ALPHA8 : GL_RGBA8;
  gl::Texture texture = gl::create_texture(format, image.width, image.height, static_cast<GLsizei>(levels.size() + 1));
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const auto copy = [&](GLint level, const std::uint8_t* rgba) {
    glTextureSubImage2D(texture.id(), level, 0, 0, std::max(image.width >> level, 1),
                        std::max(image.height >> level, 1), GL_RGBA, GL_UNSIGNED_BYTE, rgba);
  };
  copy(0, image.rgba.data());
  for (std::size_t i = 0; i < levels.size(); ++i) copy(static_cast<GLint>(i + 1), levels[i].data());
  return texture;
}

gl::Texture create_white() {
  constexpr std::array<std::uint8_t, 4> white = {255, 255, 255, 255};
  return create_image({1, 1, white}, ImageKind::numbers);
}

Status check_size(const ImageData& image, std::size_t index) {
  const int limit = gl::ask_device_limits().texture;
  if (image.width <= limit && image.height <= limit) return Done{};
  return Error{"image " + std::to_string(index) + " is " + std::to_string(image.width) + "x" +
               std::to_string(image.height) + "; this device takes " + std::to_string(limit) + ", scale it down"};
}

bool shows_color(const MaterialData& material, int image) {
  return material.base_color_texture.image == image || material.emission_texture.image == image;
}

bool reads_numbers(const MaterialData& material, int image) {
  return material.metallic_roughness_texture.image == image || material.normal_texture.image == image ||
         material.occlusion_texture.image == image;
}

bool is_plain(const MaterialData& material) {
  const bool shines = material.unlit || std::ranges::any_of(material.emission, [](float c) { return c != 0.0F; });
  const bool is_even = material.metallic_roughness_texture.image < 0 && material.normal_texture.image < 0 &&
                       material.occlusion_texture.image < 0;
  return !shines && is_even && !material.double_sided && material.metallic == 0.0F && material.roughness >= matt;
}

}  // namespace

Result<MaterialSet> MaterialSet::create(const CrowdMeshData& data) {
  MaterialSet set;
  set.white_ = create_white();
  if (const Status added = set.add_images(data); !added) return added.error();
  for (const MaterialData& material : data.materials) {
    const float* color = material.base_color;
    const float* emission = material.emission;
    const float bumps = material.normal_texture.image < 0 ? 0.0F : material.normal_scale;
    const float occlusion = material.occlusion_texture.image < 0 ? 0.0F : material.occlusion_strength;
    set.materials_.push_back(
        {.base_color = {color[0], color[1], color[2], color[3]},
         .base_color_texture = set.texture(material.base_color_texture, set.colors_),
         .emission = {emission[0], emission[1], emission[2]},
         .emission_texture = set.texture(material.emission_texture, set.colors_),
         .metallic_roughness_texture = set.texture(material.metallic_roughness_texture, set.numbers_),
         .normal_texture = set.texture(material.normal_texture, set.numbers_),
         .occlusion_texture = set.texture(material.occlusion_texture, set.numbers_),
         .factors = {material.metallic, material.roughness, bumps, occlusion},
         .is_textured = material.base_color_texture.image >= 0,
         .is_plain = is_plain(material),
         .unlit = material.unlit,
         .double_sided = material.double_sided,
         .coverage = coverage_of(data, static_cast<int>(set.materials_.size())),
         .alpha_cutoff = material.alpha_cutoff});
  }
  return set;
}

Status MaterialSet::add_images(const CrowdMeshData& data) {
  const auto add = [&data](Images& images, ImageKind kind, int index, const auto& uses) -> Status {
    gl::Texture& texture = images.emplace_back();
    const auto is_used = [&](const MaterialData& material) { return uses(material, index); };
    if (!std::ranges::any_of(data.materials, is_used)) return Done{};
    const auto place = static_cast<std::size_t>(index);
    if (Status fits = check_size(data.images[place], place); !fits) return fits;
    texture = create_image(data.images[place], kind);
    return Done{};
  };
  for (int i = 0; i < static_cast<int>(data.images.size()); ++i) {
    if (Status added = add(colors_, ImageKind::colors, i, shows_color); !added) return added;
    if (Status added = add(numbers_, ImageKind::numbers, i, reads_numbers); !added) return added;
  }
  return Done{};
}

CrowdTexture MaterialSet::texture(const TextureData& data, const Images& images) {
  const gl::Texture& image = data.image < 0 ? white_ : images[static_cast<std::size_t>(data.image)];
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
