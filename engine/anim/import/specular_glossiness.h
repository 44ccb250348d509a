#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "engine/anim/asset/model.h"

namespace throng::import {

/// A point of a surface as KHR_materials_pbrSpecularGlossiness describes it: linear colours.
struct SpecularGlossiness {
  glm::vec4 diffuse{1.0F};
  glm::vec3 specular{1.0F};
  float glossiness = 1.0F;

  bool operator==(const SpecularGlossiness&) const = default;
};

/// The same point as glTF 2.0 describes it.
struct MetallicRoughness {
  glm::vec4 base_color{1.0F};
  float metallic = 1.0F;
  float roughness = 1.0F;
};

/// Returns the point that looks alike, as far as light goes: diffuse and mirrored light are kept where a dielectric
/// that mirrors 4%, a metal, or a mixture of them has such (Khronos, "Specular-Glossiness to Metallic-Roughness").
MetallicRoughness to_metallic_roughness(const SpecularGlossiness& point);

/// Two images of the same size. They replace the images of diffuse colour, and of specular colour and glossiness.
struct MetallicRoughnessImages {
  anim::Image base_color;          ///< sRGB, alpha of the diffuse colour
  anim::Image metallic_roughness;  ///< linear, roughness in green, metallic in blue
};

/// Returns the sides of those images: the larger ones of both. Without pixels an image is plain white.
glm::ivec2 sides_of_both(const anim::Image& diffuse, const anim::Image& specular_glossiness);

/// Converts the images texel by texel, times `factors`.
MetallicRoughnessImages to_metallic_roughness(const anim::Image& diffuse, const anim::Image& specular_glossiness,
                                              const SpecularGlossiness& factors);

}  // namespace throng::import
