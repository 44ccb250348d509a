#include "engine/anim/import/materials.h"

#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "engine/anim/import/refusal.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#include <stb/stb_image.h>

namespace throng::import {

namespace {

constexpr int max_image_side = 8192;  // pixels

/// Decodes PNG or JPEG. Throws Refusal.
anim::Image decode_image(std::span<const std::byte> bytes) {
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const auto size = static_cast<int>(bytes.size());
  anim::Image image;
  int channels = 0;
  if (stbi_info_from_memory(data, size, &image.width, &image.height, &channels) == 0) {
    throw Refusal("it is neither PNG nor JPEG");
  }
  if (image.width > max_image_side || image.height > max_image_side) {
    throw Refusal("its sides exceed " + std::to_string(max_image_side) + " pixels");
  }
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load_from_memory(data, size, &image.width, &image.height, &channels, 4), &stbi_image_free);
  if (pixels == nullptr) throw Refusal(std::string("it does not decode: ") + stbi_failure_reason());
  const std::size_t pixel_count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  image.rgba.assign(pixels.get(), pixels.get() + pixel_count * 4);
  return image;
}

glm::vec2 read_pair(const tinygltf::Value& transform, const char* key, glm::vec2 fallback) {
  const tinygltf::Value& pair = transform.Get(key);
  if (!pair.IsArray() || pair.ArrayLen() != 2 || !pair.Get(0).IsNumber() || !pair.Get(1).IsNumber()) return fallback;
  return {pair.Get(0).GetNumberAsDouble(), pair.Get(1).GetNumberAsDouble()};
}

std::vector<std::byte> read_image_bytes(Document& document, const ImageSource& source, const std::string& name) {
  if (source.buffer_view >= 0) {
    const auto bytes = document.buffer_views.views[static_cast<std::size_t>(source.buffer_view)];
    return {bytes.begin(), bytes.end()};
  }
  return document.files.read(source.uri, name, document.repairs);
}

}  // namespace

int MaterialCollector::material(int file_material) {
  const auto [found, is_new] = material_of_.try_emplace(file_material, static_cast<int>(materials_.size()));
  if (is_new) {
    materials_.push_back(
        file_material < 0 ? anim::Material{}
                          : convert(document_.gltf.materials[static_cast<std::size_t>(file_material)], file_material));
  }
  return found->second;
}

anim::Material MaterialCollector::convert(const tinygltf::Material& source, int index) {
  const auto& surface = source.pbrMetallicRoughness;
  const auto& color = surface.baseColorFactor;
  anim::Material material{.name = source.name, .double_sided = source.doubleSided};
  if (color.size() == 4) material.base_color = glm::vec4(color[0], color[1], color[2], color[3]);
  if (surface.baseColorTexture.index >= 0) material.image = image(surface.baseColorTexture.index);
  if (source.alphaMode == "MASK") material.alpha_cutoff = static_cast<float>(source.alphaCutoff);
  if (source.alphaMode == "BLEND") {
    document_.repairs.push_back(label("material", static_cast<std::size_t>(index), source.name) +
                                ": is blended, drawn as opaque");
  }
  return material;
}

int MaterialCollector::image(int texture) {
  const int source = document_.gltf.textures[static_cast<std::size_t>(texture)].source;
  if (source < 0) {
    document_.repairs.push_back("texture " + std::to_string(texture) + ": has no image that is supported, left out");
    return -1;
  }
  const auto [found, is_new] = image_of_.try_emplace(source, -1);
  if (!is_new) return found->second;
  const std::string name = "image " + std::to_string(source);
  try {
    const ImageSource& place = document_.images[static_cast<std::size_t>(source)];
    images_.push_back(decode_image(read_image_bytes(document_, place, name)));
    found->second = static_cast<int>(images_.size()) - 1;
  } catch (const Refusal& refusal) {
    document_.repairs.push_back(name + ": left out, because " + refusal.what());
  }
  return found->second;
}

glm::mat3 MaterialCollector::texture_transform(int file_material) const {
  if (file_material < 0) return glm::mat3(1.0F);
  const auto& texture =
      document_.gltf.materials[static_cast<std::size_t>(file_material)].pbrMetallicRoughness.baseColorTexture;
  const auto found = texture.extensions.find("KHR_texture_transform");
  if (found == texture.extensions.end() || !found->second.IsObject()) return glm::mat3(1.0F);
  const glm::vec2 offset = read_pair(found->second, "offset", glm::vec2(0.0F));
  const glm::vec2 scale = read_pair(found->second, "scale", glm::vec2(1.0F));
  const tinygltf::Value& angle = found->second.Get("rotation");
  const float rotation = angle.IsNumber() ? static_cast<float>(angle.GetNumberAsDouble()) : 0.0F;
  const float c = std::cos(rotation);
  const float s = std::sin(rotation);
  return {c * scale.x, -s * scale.x, 0.0F, s * scale.y, c * scale.y, 0.0F, offset.x, offset.y, 1.0F};
}

}  // namespace throng::import
