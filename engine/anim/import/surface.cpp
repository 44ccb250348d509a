#include "engine/anim/import/surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/matrix.hpp>

#include "engine/anim/import/accessor_reader.h"
#include "engine/anim/import/refusal.h"
#include "engine/anim/import/triangles.h"

namespace throng::import {

namespace {

constexpr float largest_region = 5.0F;

// KHR_mesh_quantization allows these for positions, normals and texture coordinates.
constexpr std::initializer_list<int> any_component = {
    TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_BYTE, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
    TINYGLTF_COMPONENT_TYPE_SHORT, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT};

class SurfaceReader {
 public:
  SurfaceReader(Document& document, const tinygltf::Primitive& primitive, const std::string& name)
      : document_(document), primitive_(primitive), name_(name) {}

  anim::SkinnedMesh read(const glm::dmat4& placement, MaterialCollector& materials) {
    if (!primitive_.attributes.contains("POSITION")) {
      document_.repairs.push_back(name_ + ": has no POSITION, left out");
      return {};
    }
    mesh_.positions = read_vectors("POSITION", true);
    mesh_.indices = read_triangles(document_, primitive_, mesh_.positions.size(), name_);
    mend_positions();
    if (primitive_.attributes.contains("NORMAL")) mesh_.normals = read_vectors("NORMAL", false);
    read_texture_coords(materials);
    read_colors();
    read_regions();
    read_variations();
    if (!primitive_.targets.empty()) document_.repairs.push_back(name_ + ": its morph targets are ignored");
    place(placement);
    mend_normals();
    mesh_.material = materials.material(primitive_.material);
    return std::move(mesh_);
  }

 private:
  /// Returns flat numbers of an attribute, one element a position; none where the primitive lacks it.
  std::vector<float> read_attribute(const char* attribute, const AccessorRule& rule, std::size_t width) const {
    const auto found = primitive_.attributes.find(attribute);
    if (found == primitive_.attributes.end()) return {};
    auto values = read_floats(document_, found->second, rule);
    if (!mesh_.positions.empty() && values.size() != mesh_.positions.size() * width) {
      throw Refusal(name_ + ": has another number of " + attribute + " than of POSITION; export the file again");
    }
    return values;
  }

  std::vector<glm::vec3> read_vectors(const char* attribute, bool raw) const {
    const auto values = read_attribute(
        attribute,
        {.what = name_ + ": " + attribute, .types = {TINYGLTF_TYPE_VEC3}, .components = any_component, .raw = raw}, 3);
    std::vector<glm::vec3> vectors;
    vectors.reserve(values.size() / 3);
    for (std::size_t i = 0; i < values.size(); i += 3) vectors.emplace_back(values[i], values[i + 1], values[i + 2]);
    return vectors;
  }

  /// Some exporters write NaN for a vertex that should not be drawn. Drops its triangles.
  void mend_positions() {
    std::vector<bool> broken(mesh_.positions.size(), false);
    std::size_t count = 0;
    for (std::size_t vertex = 0; vertex < broken.size(); ++vertex) {
      glm::vec3& position = mesh_.positions[vertex];
      if (std::isinf(position.x) || std::isinf(position.y) || std::isinf(position.z)) {
        throw Refusal(name_ + ": position " + std::to_string(vertex) + " is infinite; export the file again");
      }
      if (!std::isnan(position.x + position.y + position.z)) continue;
      broken[vertex] = true;
      position = glm::vec3(0.0F);
      ++count;
    }
    if (count == 0) return;
    std::vector<std::uint32_t> whole;
    for (std::size_t i = 0; i < mesh_.indices.size(); i += 3) {
      const std::uint32_t* corners = mesh_.indices.data() + i;
      if (!broken[corners[0]] && !broken[corners[1]] && !broken[corners[2]]) {
        whole.insert(whole.end(), corners, corners + 3);
      }
    }
    mesh_.indices = std::move(whole);
    document_.repairs.push_back(name_ + ": " + std::to_string(count) +
                                " positions are no numbers, their triangles left out");
  }

  void read_texture_coords(const MaterialCollector& materials) {
    const auto values = read_attribute(
        "TEXCOORD_0",
        {.what = name_ + ": TEXCOORD_0", .types = {TINYGLTF_TYPE_VEC2}, .components = any_component, .raw = true}, 2);
    const glm::mat3 transform = materials.texture_transform(primitive_.material);
    mesh_.texture_coords.reserve(values.size() / 2);
    for (std::size_t i = 0; i < values.size(); i += 2) {
      mesh_.texture_coords.emplace_back(transform * glm::vec3(values[i], values[i + 1], 1.0F));
    }
  }

  void read_colors() {
    const auto found = primitive_.attributes.find("COLOR_0");
    if (found == primitive_.attributes.end()) return;
    const std::size_t width = accessor_at(document_, found->second).type == TINYGLTF_TYPE_VEC3 ? 3 : 4;
    const auto values =
        read_attribute("COLOR_0",
                       {.what = name_ + ": COLOR_0",
                        .types = {TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC4},
                        .components = {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
                                       TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT}},
                       width);
    mesh_.colors.reserve(values.size() / width);
    for (std::size_t i = 0; i < values.size(); i += width) {
      mesh_.colors.emplace_back(values[i], values[i + 1], values[i + 2], width == 4 ? values[i + 3] : 1.0F);
    }
  }

  void read_regions() {
    const auto values =
        read_attribute("_REGION",
                       {.what = name_ + ": _REGION",
                        .types = {TINYGLTF_TYPE_SCALAR},
                        .components = {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
                                       TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT},
                        .raw = true},
                       1);
    mesh_.regions.reserve(values.size());
    for (const float value : values) {
      const bool known = value >= 0.0F && value <= largest_region;
      mesh_.regions.push_back(static_cast<std::uint8_t>(known ? std::lround(value) : 0));
    }
  }

  /// Reads what an instance may vary. Drawing stores it in bytes, so values are clamped to -1..1.
  void read_variations() {
    const auto cut = [](float value) {
      return value >= -1.0F && value <= 1.0F ? value : std::clamp(value, -1.0F, 1.0F);
    };
    const auto shapes = read_attribute(
        "_SHAPE",
        {.what = name_ + ": _SHAPE", .types = {TINYGLTF_TYPE_VEC3}, .components = {TINYGLTF_COMPONENT_TYPE_FLOAT}}, 3);
    for (std::size_t i = 0; i < shapes.size(); i += 3) {
      mesh_.shapes.emplace_back(cut(shapes[i]), cut(shapes[i + 1]), cut(shapes[i + 2]));
    }
    const auto hair = read_attribute(
        "_HAIR",
        {.what = name_ + ": _HAIR", .types = {TINYGLTF_TYPE_VEC2}, .components = {TINYGLTF_COMPONENT_TYPE_FLOAT}}, 2);
    for (std::size_t i = 0; i < hair.size(); i += 2) mesh_.hair.emplace_back(cut(hair[i]), cut(hair[i + 1]));
  }

  void place(const glm::dmat4& placement) {
    const glm::dmat3 linear(placement);
    for (glm::vec3& position : mesh_.positions) {
      position = glm::vec3(placement * glm::dvec4(glm::dvec3(position), 1.0));
    }
    // The cofactors are the inverse transpose times the determinant, and exist for singular matrices too.
    const double side = glm::determinant(linear) < 0.0 ? -1.0 : 1.0;
    const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                               glm::cross(linear[0], linear[1]));
    for (glm::vec3& normal : mesh_.normals) {
      const glm::dvec3 turned = cofactors * glm::dvec3(normal) * side;
      const double length = glm::length(turned);
      normal = length > 0.0 ? glm::vec3(turned / length) : glm::vec3(0.0F);
    }
    if (side > 0.0) return;
    for (std::size_t i = 0; i < mesh_.indices.size(); i += 3) std::swap(mesh_.indices[i + 1], mesh_.indices[i + 2]);
  }

  void mend_normals() {
    const auto is_unit = [](const glm::vec3& normal) { return std::abs(glm::length(normal) - 1.0F) < 1e-3F; };
    if (!mesh_.normals.empty() && std::ranges::all_of(mesh_.normals, is_unit)) return;
    const auto computed = compute_normals(mesh_.positions, mesh_.indices);
    if (mesh_.normals.empty()) {
      mesh_.normals = computed;
      return;
    }
    std::size_t mended = 0;
    for (std::size_t vertex = 0; vertex < computed.size(); ++vertex) {
      if (is_unit(mesh_.normals[vertex])) continue;
      mesh_.normals[vertex] = computed[vertex];
      ++mended;
    }
    document_.repairs.push_back(name_ + ": " + std::to_string(mended) + " normals had no direction, computed");
  }

  Document& document_;
  const tinygltf::Primitive& primitive_;
  const std::string& name_;
  anim::SkinnedMesh mesh_;
};

}  // namespace

anim::SkinnedMesh read_surface(Document& document, const tinygltf::Primitive& primitive, const glm::dmat4& placement,
                               MaterialCollector& materials, const std::string& name) {
  return SurfaceReader(document, primitive, name).read(placement, materials);
}

}  // namespace throng::import
