#include "engine/anim/import/materials.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <glm/vec2.hpp>

#include "engine/anim/base/elementary.h"
#include "engine/anim/import/bytes/refusal.h"
#include "engine/anim/import/images.h"
#include "engine/anim/import/pixels/decode.h"

namespace throng::import {

using Extensions = tinygltf::ExtensionMap;

/// Names the texture of a property, in a material or in one of its extensions.
struct TextureReference {
  int texture = -1;
  int set = 0;
  const tinygltf::Value* transform = nullptr;  ///< KHR_texture_transform
};

namespace {

const tinygltf::Value* find_extension(const Extensions& extensions, const char* name) {
  const auto found = extensions.find(name);
  return found == extensions.end() ? nullptr : &found->second;
}

const tinygltf::Value* find_member(const tinygltf::Value& object, const char* name) {
  return object.Has(name) ? &object.Get(name) : nullptr;
}

float read_number(const tinygltf::Value& object, const char* name, float fallback) {
  const tinygltf::Value* number = find_member(object, name);
  return number == nullptr ? fallback : static_cast<float>(number->GetNumberAsDouble());
}

template <typename Vector>
Vector read_vector(const tinygltf::Value& object, const char* name, Vector fallback) {
  const tinygltf::Value* member = find_member(object, name);
  if (member == nullptr) return fallback;
  glm::length_t i = 0;
  for (const tinygltf::Value& number : member->Get<tinygltf::Value::Array>()) {
    if (i < Vector::length()) fallback[i++] = static_cast<float>(number.GetNumberAsDouble());
  }
  return fallback;
}

TextureReference reference_of(const auto& info) {
  return {.texture = info.index,
          .set = info.texCoord,
          .transform = find_extension(info.extensions, "KHR_texture_transform")};
}

TextureReference reference_in(const tinygltf::Value& extension, const char* name) {
  const tinygltf::Value* info = find_member(extension, name);
  if (info == nullptr) return {};
  const tinygltf::Value* extensions = find_member(*info, "extensions");
  const tinygltf::Value* set = find_member(*info, "texCoord");
  return {.texture = info->Get("index").GetNumberAsInt(),
          .set = set == nullptr ? 0 : set->GetNumberAsInt(),
          .transform = extensions == nullptr ? nullptr : find_member(*extensions, "KHR_texture_transform")};
}

glm::mat3 transform_of(const tinygltf::Value& transform) {
  const auto offset = read_vector(transform, "offset", glm::vec2(0.0F));
  const auto scale = read_vector(transform, "scale", glm::vec2(1.0F));
  const float rotation = read_number(transform, "rotation", 0.0F);
  const float c = anim::cosine(rotation);
  const float s = anim::sine(rotation);
  return {c * scale.x, -s * scale.x, 0.0F, s * scale.y, c * scale.y, 0.0F, offset.x, offset.y, 1.0F};
}

CoordsSource coords_source(const TextureReference& reference) {
  CoordsSource source{.set = reference.set};
  if (reference.transform == nullptr) return source;
  source.transform = transform_of(*reference.transform);
  if (const tinygltf::Value* set = find_member(*reference.transform, "texCoord")) source.set = set->GetNumberAsInt();
  return source;
}

constexpr std::array wraps{anim::Wrap::clamp, anim::Wrap::mirror, anim::Wrap::repeat};
constexpr std::array magnifying_filters{anim::Filter::nearest, anim::Filter::linear};
constexpr std::array minifying_filters{anim::Filter::nearest,
                                       anim::Filter::linear,
                                       anim::Filter::nearest_of_nearest,
                                       anim::Filter::linear_of_nearest,
                                       anim::Filter::nearest_of_linear,
                                       anim::Filter::linear_of_linear};

/// Sets `value` to the choice that has the number of the file. Returns false for a number that no choice has; -1 stands
/// for none and leaves `value` as it is.
template <typename Choice>
bool choose(int number, const auto& choices, Choice& value) {
  if (number == -1) return true;
  const auto found = std::ranges::find(choices, number, [](Choice choice) { return static_cast<int>(choice); });
  if (found == choices.end()) return false;
  value = *found;
  return true;
}

/// Returns a texture's image of an extension, or -1.
int image_in(const tinygltf::Texture& texture, const char* extension) {
  const tinygltf::Value* found = find_extension(texture.extensions, extension);
  const tinygltf::Value* source = found == nullptr ? nullptr : find_member(*found, "source");
  return source == nullptr ? -1 : source->GetNumberAsInt();
}

glm::vec3 emission_of(const tinygltf::Material& source) {
  const auto& factor = source.emissiveFactor;
  if (factor.size() != 3) return glm::vec3(0.0F);
  const tinygltf::Value* strength = find_extension(source.extensions, "KHR_materials_emissive_strength");
  const float times = strength == nullptr ? 1.0F : read_number(*strength, "emissiveStrength", 1.0F);
  return glm::vec3(factor[0], factor[1], factor[2]) * times;
}

}  // namespace

int MaterialCollector::material(int file_material) {
  const auto [found, is_new] = material_of_.try_emplace(file_material, static_cast<int>(materials_.size()));
  if (!is_new) return found->second;
  constexpr std::uint64_t bytes = 3 * sizeof(anim::Material) + 1024;  // with its name, in a vector that grows
  document_.memory->charge_for_good(bytes, "material " + std::to_string(file_material));
  coords_.emplace_back();
  materials_.push_back(file_material < 0 ? anim::Material{}
                                         : convert(document_.gltf.materials[static_cast<std::size_t>(file_material)]));
  return found->second;
}

anim::Material MaterialCollector::convert(const tinygltf::Material& source) {
  const auto& surface = source.pbrMetallicRoughness;
  const auto& color = surface.baseColorFactor;
  anim::Material material;
  material.name = source.name;
  material.double_sided = source.doubleSided;
  if (color.size() == 4) material.base_color = glm::vec4(color[0], color[1], color[2], color[3]);
  material.metallic = static_cast<float>(surface.metallicFactor);
  material.roughness = static_cast<float>(surface.roughnessFactor);
  const auto* extension = find_extension(source.extensions, "KHR_materials_pbrSpecularGlossiness");
  if (extension != nullptr && surface.metallicRoughnessTexture.index < 0) {
    read_specular_glossiness(*extension, material);
  } else {
    material.base_color_texture = texture(reference_of(surface.baseColorTexture));
    material.metallic_roughness_texture = texture(reference_of(surface.metallicRoughnessTexture));
  }
  material.emission = emission_of(source);
  if (material.emission != glm::vec3(0.0F)) material.emission_texture = texture(reference_of(source.emissiveTexture));
  material.normal_scale = static_cast<float>(source.normalTexture.scale);
  material.normal_texture = texture(reference_of(source.normalTexture));
  material.occlusion_strength = static_cast<float>(source.occlusionTexture.strength);
  material.occlusion_texture = texture(reference_of(source.occlusionTexture));
  material.unlit = find_extension(source.extensions, "KHR_materials_unlit") != nullptr;
  material.blended = source.alphaMode == "BLEND";
  if (source.alphaMode == "MASK") material.alpha_cutoff = static_cast<float>(source.alphaCutoff);
  return material;
}

/// Converts factors, or factors and images where a texture or two of the same coordinates need it. A file that brings
/// metallic and roughness in a texture besides is read by that one.
void MaterialCollector::read_specular_glossiness(const tinygltf::Value& extension, anim::Material& material) {
  constexpr float brightest_dielectric = 0.08F;  // specular: gems reflect more, but no character is made of them
  const SpecularGlossiness factors{.diffuse = read_vector(extension, "diffuseFactor", glm::vec4(1.0F)),
                                   .specular = read_vector(extension, "specularFactor", glm::vec3(1.0F)),
                                   .glossiness = read_number(extension, "glossinessFactor", 1.0F)};
  const MetallicRoughness plain = to_metallic_roughness(factors);
  material.base_color = plain.base_color;
  material.metallic = plain.metallic;
  material.roughness = plain.roughness;
  const TextureReference diffuse = reference_in(extension, "diffuseTexture");
  const TextureReference specular = reference_in(extension, "specularGlossinessTexture");
  const bool has_both = diffuse.texture >= 0 && specular.texture >= 0;
  const bool mirrors = std::max({factors.specular.r, factors.specular.g, factors.specular.b}) > brightest_dielectric;
  if (has_both && coords_source(diffuse) == coords_source(specular)) {
    convert_images(diffuse, specular, factors, material);
  } else if (diffuse.texture < 0 && specular.texture >= 0) {
    convert_images(diffuse, specular, factors, material);
  } else if (diffuse.texture >= 0 && specular.texture < 0 && mirrors) {
    convert_images(diffuse, specular, factors, material);
  } else if (diffuse.texture >= 0) {
    material.base_color = factors.diffuse;
    material.base_color_texture = texture(diffuse);
    material.metallic = 0.0F;
  }
}

void MaterialCollector::convert_images(const TextureReference& diffuse, const TextureReference& specular,
                                       const SpecularGlossiness& factors, anim::Material& material) {
  const auto read = [this](const TextureReference& reference) {
    const auto found = reference.texture < 0 ? std::nullopt : image_of(reference.texture);
    return found ? *found : anim::Image{};
  };
  const anim::Image diffuse_image = read(diffuse), specular_image = read(specular);
  if (sides_of_both(diffuse_image, specular_image).x == 0) return;
  const int base_color = index_of_converted(diffuse_image, specular_image, factors);
  material.base_color = glm::vec4(1.0F);
  material.metallic = 1.0F;
  material.roughness = 1.0F;
  material.base_color_texture = placed(diffuse.texture >= 0 ? diffuse : specular);
  material.base_color_texture.image = base_color;
  material.metallic_roughness_texture = material.base_color_texture;
  material.metallic_roughness_texture.image = base_color + 1;
}

int MaterialCollector::index_of_converted(const anim::Image& diffuse, const anim::Image& specular,
                                          const SpecularGlossiness& factors) {
  const ConvertedImages key{diffuse.rgba.data(), specular.rgba.data(), factors, static_cast<int>(images_.size())};
  const auto is_same = [&key](const ConvertedImages& other) {
    return other.diffuse == key.diffuse && other.specular == key.specular && other.factors == key.factors;
  };
  const auto known = std::ranges::find_if(converted_, is_same);
  if (known != converted_.end()) return known->base_color;
  const glm::ivec2 sides = sides_of_both(diffuse, specular);
  document_.memory->charge_for_image(2 * rgba_size(sides.x, sides.y), "images of specular and glossy materials");
  MetallicRoughnessImages images = to_metallic_roughness(diffuse, specular, factors);
  images_.push_back(std::move(images.base_color));
  images_.push_back(std::move(images.metallic_roughness));
  converted_.push_back(key);
  return key.base_color;
}

anim::Texture MaterialCollector::texture(const TextureReference& reference) {
  anim::Texture texture;
  if (reference.texture < 0) return texture;
  const std::optional<anim::Image> image = image_of(reference.texture);
  if (!image) return texture;
  texture = placed(reference);
  texture.image = index_of(*image);
  return texture;
}

anim::Texture MaterialCollector::placed(const TextureReference& reference) {
  anim::Texture texture;
  texture.coords = coords_index(coords_source(reference));
  read_sampler(document_.gltf.textures[static_cast<std::size_t>(reference.texture)].sampler, texture);
  return texture;
}

int MaterialCollector::coords_index(const CoordsSource& source) {
  std::vector<CoordsSource>& known = coords_.back();  // of the material that is being converted
  const auto found = std::ranges::find(known, source);
  const auto index = static_cast<int>(found - known.begin());
  if (found == known.end()) known.push_back(source);
  return index;
}

void MaterialCollector::read_sampler(int sampler, anim::Texture& texture) {
  if (sampler < 0) return;
  const tinygltf::Sampler& source = document_.gltf.samplers[static_cast<std::size_t>(sampler)];
  bool known = choose(source.wrapS, wraps, texture.wrap_u);
  known = choose(source.wrapT, wraps, texture.wrap_v) && known;
  known = choose(source.magFilter, magnifying_filters, texture.magnified) && known;
  known = choose(source.minFilter, minifying_filters, texture.minified) && known;
  const std::string sentence = label("sampler", static_cast<std::size_t>(sampler), source.name) +
                               ": a filter or wrap of it is unknown, left out";
  if (!known && !std::ranges::count(document_.repairs, sentence)) document_.repairs.push_back(sentence);
}

/// Prefers WebP, because a texture that has it keeps the PNG or JPEG beside it for programs that cannot read it.
std::optional<anim::Image> MaterialCollector::image_of(int texture) {
  const tinygltf::Texture& source = document_.gltf.textures[static_cast<std::size_t>(texture)];
  for (const int candidate : {image_in(source, "EXT_texture_webp"), source.source}) {
    if (candidate < 0) continue;
    if (const auto found = image(candidate)) return found;
  }
  if (source.source < 0 && image_in(source, "EXT_texture_webp") < 0) {
    const bool is_ktx2 = image_in(source, "KHR_texture_basisu") >= 0;
    document_.repairs.push_back(
        "texture " + std::to_string(texture) + ": has " +
        (is_ktx2 ? "KTX2, which is not decoded, and no PNG or JPEG beside it" : "no image that is supported") +
        ", left out");
  }
  return std::nullopt;
}

std::optional<anim::Image> MaterialCollector::image(int file_image) {
  const auto [found, is_new] = read_images_.try_emplace(file_image, std::nullopt);
  if (!is_new) return found->second;
  try {
    found->second = read_image(document_, file_image);
  } catch (const Refusal& refusal) {
    document_.repairs.push_back(image_label(document_, file_image) + ": left out, because " + refusal.what());
  }
  return found->second;
}

int MaterialCollector::index_of(const anim::Image& image) {
  const auto same = std::ranges::find(images_, image.rgba.data(), [](const anim::Image& i) { return i.rgba.data(); });
  const auto index = static_cast<int>(same - images_.begin());
  if (same == images_.end()) images_.push_back(image);
  return index;
}

}  // namespace throng::import
