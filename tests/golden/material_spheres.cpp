#include "tests/golden/material_spheres.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "throng/render/image.h"

namespace throng::app::test {
namespace {

using nlohmann::json;

constexpr int columns = 4, rows = 3;
constexpr int slices = 48, rings = 24;
constexpr float radius = 0.28F, apart = 0.6F;  // metres
constexpr float pi = std::numbers::pi_v<float>;
constexpr int image_width = 128, image_height = 64;

/// Collects the buffer of the file with its views and accessors.
class Buffer {
 public:
  template <typename T>
  int add(const std::vector<T>& elements, int component, const char* type, json more = json::object()) {
    const std::size_t offset = bytes_.size(), size = elements.size() * sizeof(T);
    const auto* first = reinterpret_cast<const char*>(elements.data());
    bytes_.insert(bytes_.end(), first, first + size);
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    views_.push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}});
    more.update(
        {{"bufferView", views_.size() - 1}, {"componentType", component}, {"count", elements.size()}, {"type", type}});
    accessors_.push_back(std::move(more));
    return static_cast<int>(accessors_.size()) - 1;
  }

  void write(const std::filesystem::path& folder, json& document) const {
    std::ofstream(folder / "spheres.bin", std::ios::binary)
        .write(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
    document["buffers"] = json::array({{{"uri", "spheres.bin"}, {"byteLength", bytes_.size()}}});
    document["bufferViews"] = views_;
    document["accessors"] = accessors_;
  }

 private:
  std::vector<char> bytes_;
  json views_ = json::array(), accessors_ = json::array();
};

constexpr int bytes = 5121, shorts = 5123, floats = 5126;

std::vector<glm::vec3> sphere_normals() {
  std::vector<glm::vec3> normals;
  for (int ring = 0; ring <= rings; ++ring) {
    for (int slice = 0; slice <= slices; ++slice) {
      const float down = pi * static_cast<float>(ring) / rings;
      const float around = 2.0F * pi * (static_cast<float>(slice) / slices - 0.5F);
      normals.emplace_back(std::sin(down) * std::sin(around), std::cos(down), std::sin(down) * std::cos(around));
    }
  }
  return normals;
}

std::vector<glm::vec2> sphere_coords() {
  std::vector<glm::vec2> coords;
  for (int ring = 0; ring <= rings; ++ring) {
    for (int slice = 0; slice <= slices; ++slice) {
      coords.emplace_back(static_cast<float>(slice) / slices, static_cast<float>(ring) / rings);
    }
  }
  return coords;
}

std::vector<std::uint16_t> sphere_triangles() {
  std::vector<std::uint16_t> indices;
  for (int ring = 0; ring < rings; ++ring) {
    for (int slice = 0; slice < slices; ++slice) {
      const auto a = static_cast<std::uint16_t>(ring * (slices + 1) + slice);
      const auto b = static_cast<std::uint16_t>(a + slices + 1);
      for (const int index : {a + 0, b + 0, a + 1, a + 1, b + 0, b + 1}) {
        indices.push_back(static_cast<std::uint16_t>(index));
      }
    }
  }
  return indices;
}

/// Adds the spheres as primitives of one mesh: they share all but their positions.
json sphere_primitives(Buffer& buffer) {
  const std::vector<glm::vec3> normals = sphere_normals();
  std::vector<glm::vec4> colors;
  for (const glm::vec3& normal : normals) colors.emplace_back(0.5F + 0.5F * normal, 1.0F);
  const int normal = buffer.add(normals, floats, "VEC3"), coords = buffer.add(sphere_coords(), floats, "VEC2");
  const int joints = buffer.add(std::vector<std::array<std::uint8_t, 4>>(normals.size()), bytes, "VEC4");
  const int weights = buffer.add(std::vector<glm::vec4>(normals.size(), {1, 0, 0, 0}), floats, "VEC4");
  const int color = buffer.add(colors, floats, "VEC4"), triangles = buffer.add(sphere_triangles(), shorts, "SCALAR");
  json primitives = json::array();
  for (int i = 0; i < columns * rows; ++i) {
    const glm::vec3 middle((static_cast<float>(i % columns) - 1.5F) * apart,
                           (static_cast<float>(rows - 1 - i / columns) + 0.5F) * apart, 0.0F);
    std::vector<glm::vec3> positions;
    for (const glm::vec3& of_sphere : normals) positions.push_back(middle + radius * of_sphere);
    const glm::vec3 low = middle - radius, high = middle + radius;
    const int position =
        buffer.add(positions, floats, "VEC3", {{"min", {low.x, low.y, low.z}}, {"max", {high.x, high.y, high.z}}});
    json attributes = {{"POSITION", position},
                       {"NORMAL", normal},
                       {"TEXCOORD_0", coords},
                       {"JOINTS_0", joints},
                       {"WEIGHTS_0", weights}};
    if (i == 10) attributes["COLOR_0"] = color;
    primitives.push_back({{"attributes", attributes}, {"indices", triangles}, {"material", i}});
  }
  return primitives;
}

using Texel = glm::vec4;  // 0 to 1

/// Gives the place of a texel in a cell of a pattern of eight by four: -1 to 1 to the right and down.
glm::vec2 in_cell(const glm::vec2& place) { return 2.0F * glm::fract(place * glm::vec2(8.0F, 4.0F)) - 1.0F; }

bool is_odd(const glm::vec2& place) {
  const glm::ivec2 cell(place * glm::vec2(8.0F, 4.0F));
  return (cell.x + cell.y) % 2 != 0;
}

Texel bump_at(const glm::vec2& place) {
  const glm::vec2 at = in_cell(place) / 0.8F;
  const float height = std::sqrt(std::max(1.0F - glm::dot(at, at), 0.0F));
  if (height == 0.0F) return {0.5F, 0.5F, 1.0F, 1.0F};
  return {0.5F + 0.5F * at.x, 0.5F - 0.5F * at.y, 0.5F + 0.5F * height, 1.0F};  // green points up
}

/// The images of the file, in the order of its textures.
const std::array<std::function<Texel(const glm::vec2&)>, 6> images{
    [](const glm::vec2& place) {
      return is_odd(place) ? Texel{1, 0.25F, 1, 1} : Texel{1, 0.9F, 0, 1};
    },
    bump_at,
    [](const glm::vec2& place) { return Texel(glm::vec3(is_odd(place) ? 0.1F : 1.0F), 1); },
    [](const glm::vec2& place) {
      return glm::length(in_cell(place)) < 0.5F ? Texel{1, 0.6F, 0.1F, 1} : Texel{0, 0, 0, 1};
    },
    [](const glm::vec2& place) {
      return Texel{1, 1, 1, glm::length(in_cell(place)) < 0.7F ? 0.0F : 1.0F};
    },
    [](const glm::vec2& place) {
      return is_odd(place) ? Texel{0.95F, 0.75F, 0.55F, 0.8F} : Texel{0.2F, 0.2F, 0.2F, 0.3F};
    }};

void write_images(const std::filesystem::path& folder, json& document) {
  for (std::size_t i = 0; i < images.size(); ++i) {
    render::Image image = render::Image::blank(image_width, image_height);
    for (int y = 0; y < image_height; ++y) {
      for (int x = 0; x < image_width; ++x) {
        const Texel texel = images.at(i)((glm::vec2(x, y) + 0.5F) / glm::vec2(image_width, image_height));
        for (int c = 0; c < 4; ++c) image.pixel(x, y)[c] = static_cast<std::uint8_t>(std::lround(texel[c] * 255.0F));
      }
    }
    const std::string name = "image" + std::to_string(i) + ".png";
    EXPECT_TRUE(render::write_png(image, folder / name));
    document["images"].push_back({{"uri", name}});
    document["textures"].push_back({{"source", i}});
  }
}

json rough(float red, float green, float blue, float metallic, float roughness) {
  return {{"baseColorFactor", {red, green, blue, 1.0F}}, {"metallicFactor", metallic}, {"roughnessFactor", roughness}};
}

json materials() {
  const auto show = [](int texture) { return json{{"index", texture}}; };
  const json grey = rough(0.5F, 0.5F, 0.5F, 0, 0.5F);
  json mixed = rough(0.9F, 0.6F, 0.3F, 1, 1), holes = rough(0.2F, 0.5F, 0.2F, 0, 0.6F),
       glass = rough(0.3F, 0.5F, 0.9F, 0, 0.1F);
  mixed["metallicRoughnessTexture"] = show(0);
  holes["baseColorTexture"] = show(4);
  glass["baseColorFactor"][3] = 0.4F;
  return json::array({{{"pbrMetallicRoughness", rough(0.8F, 0.8F, 0.8F, 0, 1)}},
                      {{"pbrMetallicRoughness", rough(0.6F, 0.02F, 0.02F, 0, 0.2F)}},
                      {{"pbrMetallicRoughness", rough(1, 0.77F, 0.34F, 1, 0.3F)}},
                      {{"pbrMetallicRoughness", mixed}},
                      {{"pbrMetallicRoughness", grey}, {"normalTexture", show(1)}},
                      {{"pbrMetallicRoughness", grey}, {"occlusionTexture", show(2)}},
                      {{"pbrMetallicRoughness", rough(0.05F, 0.05F, 0.05F, 0, 0.5F)},
                       {"emissiveFactor", {1, 1, 1}},
                       {"emissiveTexture", show(3)}},
                      {{"pbrMetallicRoughness", holes}, {"alphaMode", "MASK"}, {"doubleSided", true}},
                      {{"pbrMetallicRoughness", glass}, {"alphaMode", "BLEND"}},
                      {{"pbrMetallicRoughness", grey}, {"extensions", {{"KHR_materials_unlit", json::object()}}}},
                      {{"pbrMetallicRoughness", rough(1, 1, 1, 0, 0.6F)}},
                      {{"extensions",
                        {{"KHR_materials_pbrSpecularGlossiness",
                          {{"diffuseFactor", {0.1F, 0.1F, 0.3F, 1.0F}}, {"specularGlossinessTexture", show(5)}}}}}}});
}

}  // namespace

std::filesystem::path write_material_spheres(const std::filesystem::path& folder) {
  json document = {{"asset", {{"version", "2.0"}}},
                   {"extensionsUsed", {"KHR_materials_unlit", "KHR_materials_pbrSpecularGlossiness"}},
                   {"scene", 0},
                   {"scenes", {{{"nodes", {0, 1}}}}},
                   {"nodes", {{{"name", "body"}, {"mesh", 0}, {"skin", 0}}, {{"name", "joint"}}}},
                   {"skins", {{{"joints", {1}}}}},
                   {"materials", materials()}};
  Buffer buffer;
  document["meshes"] = json::array({{{"primitives", sphere_primitives(buffer)}}});
  const int times = buffer.add(std::vector<float>{0, 1}, floats, "SCALAR", {{"min", {0}}, {"max", {1}}});
  const int rotations = buffer.add(std::vector<glm::vec4>(2, {0, 0, 0, 1}), floats, "VEC4");
  document["animations"] =
      json::array({{{"name", "still"},
                    {"channels", json::array({{{"sampler", 0}, {"target", {{"node", 1}, {"path", "rotation"}}}}})},
                    {"samplers", json::array({{{"input", times}, {"output", rotations}}})}}});
  buffer.write(folder, document);
  write_images(folder, document);
  std::ofstream(folder / "spheres.gltf") << document;
  return folder / "spheres.gltf";
}

}  // namespace throng::app::test
