#include "engine/anim/import/surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

#include <glm/ext/vector_float1.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "engine/anim/import/accessors.h"
#include "engine/anim/import/bytes/refusal.h"
#include "engine/anim/import/memory/model_memory.h"
#include "engine/anim/import/triangles.h"

namespace throng::import {

namespace {

/// Returns unit normals, weighted by the area of the triangles around each vertex; +Y for a vertex without any.
std::vector<glm::vec3> compute_normals(const std::vector<glm::vec3>& positions,
                                       const std::vector<std::uint32_t>& indices) {
  std::vector<glm::dvec3> sums(positions.size(), glm::dvec3(0.0));
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const glm::dvec3 a(positions[indices[i]]);
    const glm::dvec3 b(positions[indices[i + 1]]);
    const glm::dvec3 c(positions[indices[i + 2]]);
    const glm::dvec3 area = glm::cross(b - a, c - a);
    for (std::size_t corner = 0; corner < 3; ++corner) sums[indices[i + corner]] += area;
  }
  std::vector<glm::vec3> normals;
  normals.reserve(sums.size());
  for (const glm::dvec3& sum : sums) {
    const double length = glm::length(sum);
    normals.push_back(length > 0.0 ? glm::vec3(sum / length) : glm::vec3(0.0F, 1.0F, 0.0F));
  }
  return normals;
}

constexpr float largest_region = 8.0F;

class SurfaceReader {
 public:
  SurfaceReader(Document& document, const tinygltf::Primitive& primitive, const std::string& name)
      : document_(document), primitive_(primitive), name_(name) {}

  anim::SkinnedMesh read(const MorphsOfMesh& morphs, const glm::dmat4& placement, MaterialCollector& materials) {
    if (!primitive_.attributes.contains("POSITION")) {
      document_.repairs.push_back(name_ + ": has no POSITION, left out");
      return {};
    }
    mesh_.positions = read_attribute<glm::vec3>("POSITION", TINYGLTF_TYPE_VEC3, float_or_small, true);
    mesh_.indices = read_triangles(document_, primitive_, mesh_.positions.size(), name_);
    mesh_.material = materials.material(primitive_.material);
    mesh_.normals = read_attribute<glm::vec3>("NORMAL", TINYGLTF_TYPE_VEC3, float_or_small);
    if (materials.at(mesh_.material).normal_texture.image >= 0 && !mesh_.normals.empty()) {
      mesh_.tangents = read_attribute<glm::vec4>("TANGENT", TINYGLTF_TYPE_VEC4, float_or_small);
    }
    add_morph_targets(morphs);
    mend_positions();
    read_regions();
    read_texture_coords(materials);
    read_colors();
    read_channels();
    place(placement);
    mend_normals();
    return std::move(mesh_);
  }

 private:
  /// Returns one vector a position; none where the primitive lacks the attribute.
  template <typename Vector>
  std::vector<Vector> read_attribute(const std::string& attribute, int type, Components components,
                                     bool raw = false) const {
    return read_attribute_of<Vector>(primitive_.attributes, attribute, type, components, raw);
  }

  template <typename Vector>
  std::vector<Vector> read_attribute_of(const std::map<std::string, int>& attributes, const std::string& attribute,
                                        int type, Components components, bool raw) const {
    MemoryScope scope(*document_.memory);
    const std::vector<float> numbers = read_numbers(attributes, attribute, type, components, raw);
    document_.memory->charge(bytes_of(numbers), name_);
    scope.keep(bytes_of(numbers));
    return grouped<Vector>(numbers);
  }

  std::vector<float> read_numbers(const std::map<std::string, int>& attributes, const std::string& attribute, int type,
                                  Components components, bool raw) const {
    const auto found = attributes.find(attribute);
    if (found == attributes.end()) return {};
    std::vector<float> numbers =
        read_floats(document_, found->second, {name_ + ": " + attribute, {type}, components, raw});
    const auto width = static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(type)));
    if (!mesh_.positions.empty() && numbers.size() != mesh_.positions.size() * width) {
      refuse(name_, "has another number of " + attribute + " than of POSITION");
    }
    return numbers;
  }

  /// Adds each target times its weight at rest (glTF 2.0, 3.7.2.2), and keeps animated targets. The others are
  /// not decoded.
  void add_morph_targets(const MorphsOfMesh& morphs) {
    const std::span<const double> weights = morphs.rest_weights;
    if (weights.size() > primitive_.targets.size()) {
      document_.repairs.push_back(name_ + ": has more morph weights than targets, those beyond left out");
    }
    bool turned = false;
    for (std::size_t target = 0; target < primitive_.targets.size(); ++target) {
      const float weight = target < weights.size() ? static_cast<float>(weights[target]) : 0.0F;
      const auto morph =
          std::ranges::find(morphs.animated, static_cast<int>(target), [](const auto& m) { return m.first; });
      const bool moves = morph != morphs.animated.end();
      if (weight == 0.0F && !moves) continue;
      MemoryScope scope(*document_.memory);
      const auto& attributes = primitive_.targets[target];
      const auto offsets =
          read_attribute_of<glm::vec3>(attributes, "POSITION", TINYGLTF_TYPE_VEC3, float_or_small, true);
      std::vector<glm::vec3> turns;
      if (!mesh_.normals.empty()) {  // else they are computed of the triangles
        turns = read_attribute_of<glm::vec3>(attributes, "NORMAL", TINYGLTF_TYPE_VEC3, float_or_small, false);
      }
      add_scaled(mesh_.positions, offsets, weight);
      turned |= weight != 0.0F && add_scaled(mesh_.normals, turns, weight);
      if (moves) scope.keep(keep_deltas(morph->second, offsets, turns));
    }
    report_bad_deltas();
    if (turned) make_unit_normals();
  }

  void make_unit_normals() {
    std::vector<float> lengths;
    for (glm::vec3& normal : mesh_.normals) {
      lengths.push_back(glm::length(normal));
      if (lengths.back() > 0.0F) normal /= lengths.back();
    }
    for (anim::MorphDelta& delta : mesh_.morph_deltas) {
      if (lengths[delta.vertex] > 0.0F) delta.normal /= lengths[delta.vertex];
    }
  }

  /// Keeps the deltas of the vertices that a target moves. Most targets move few. Returns what they take in a
  /// vector that grows.
  std::uint64_t keep_deltas(std::uint32_t morph, const std::vector<glm::vec3>& offsets,
                            const std::vector<glm::vec3>& turns) {
    constexpr float least_offset = 1e-4F;  // of the largest
    constexpr float least_turn = 1e-3F;
    float largest = 0.0F;
    for (const glm::vec3& offset : offsets) largest = std::max(largest, glm::length(offset));
    constexpr std::uint64_t taken = 3 * sizeof(anim::MorphDelta);
    document_.memory->charge(mesh_.positions.size() * taken, name_);
    const std::size_t before = mesh_.morph_deltas.size();
    for (std::uint32_t vertex = 0; vertex < mesh_.positions.size(); ++vertex) {
      const glm::vec3 offset = offsets.empty() ? glm::vec3(0.0F) : offsets[vertex];
      const glm::vec3 turn = turns.empty() ? glm::vec3(0.0F) : turns[vertex];
      const float length = glm::length(offset), turned = glm::length(turn);
      if (!std::isfinite(length) || !std::isfinite(turned)) {
        ++bad_deltas_;
      } else if (length > least_offset * largest || turned > least_turn) {
        mesh_.morph_deltas.push_back({.vertex = vertex, .morph = morph, .position = offset, .normal = turn});
      }
    }
    return (mesh_.morph_deltas.size() - before) * taken;
  }

  void report_bad_deltas() {
    if (bad_deltas_ == 0) return;
    document_.repairs.push_back(name_ + ": " + std::to_string(bad_deltas_) +
                                " displacements of morph targets are no numbers, left out");
  }

  /// Returns whether there was anything to add.
  static bool add_scaled(std::vector<glm::vec3>& vectors, const std::vector<glm::vec3>& offsets, float weight) {
    for (std::size_t i = 0; i < offsets.size(); ++i) vectors[i] += weight * offsets[i];
    return !offsets.empty();
  }

  /// Some exporters write NaN for a vertex that should not be drawn. Drops its triangles.
  void mend_positions() {
    std::vector<bool> broken(mesh_.positions.size(), false);
    std::size_t count = 0;
    for (std::size_t vertex = 0; vertex < broken.size(); ++vertex) {
      glm::vec3& position = mesh_.positions[vertex];
      if (std::isinf(position.x) || std::isinf(position.y) || std::isinf(position.z)) {
        refuse(name_, "position " + std::to_string(vertex) + " is infinite");
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

  // KHR_mesh_quantization allows small integers for positions, normals and texture coordinates.
  void read_texture_coords(const MaterialCollector& materials) {
    for (const CoordsSource& source : materials.coords(mesh_.material)) {
      const std::string attribute = "TEXCOORD_" + std::to_string(source.set);
      if (!primitive_.attributes.contains(attribute)) {
        document_.repairs.push_back(name_ + ": has no " + attribute + ", so its texture shows one colour");
      }
      auto places = read_attribute<glm::vec2>(attribute, TINYGLTF_TYPE_VEC2, float_or_small, true);
      for (glm::vec2& place : places) place = glm::vec2(source.transform * glm::vec3(place, 1.0F));
      mesh_.texture_coords.push_back(std::move(places));
    }
    // A region may show a pattern, which needs coordinates too.
    if (mesh_.regions.empty() || !mesh_.texture_coords.empty() || !primitive_.attributes.contains("TEXCOORD_0")) return;
    mesh_.texture_coords.push_back(read_attribute<glm::vec2>("TEXCOORD_0", TINYGLTF_TYPE_VEC2, float_or_small));
  }

  void read_colors() {
    const auto found = primitive_.attributes.find("COLOR_0");
    if (found == primitive_.attributes.end()) return;
    if (accessor_at(document_, found->second).type != TINYGLTF_TYPE_VEC3) {
      mesh_.colors = read_attribute<glm::vec4>("COLOR_0", TINYGLTF_TYPE_VEC4, float_or_unsigned);
      return;
    }
    const auto colors = read_attribute<glm::vec3>("COLOR_0", TINYGLTF_TYPE_VEC3, float_or_unsigned);
    document_.memory->charge(colors.size() * sizeof(glm::vec4), name_);
    mesh_.colors.reserve(colors.size());
    for (const glm::vec3& color : colors) mesh_.colors.emplace_back(color, 1.0F);
  }

  void read_regions() {
    for (const auto& value : read_attribute<glm::vec1>("_REGION", TINYGLTF_TYPE_SCALAR, float_or_unsigned, true)) {
      const bool known = value.x >= 0.0F && value.x <= largest_region;
      mesh_.regions.push_back(static_cast<std::uint8_t>(known ? std::lround(value.x) : 0));
    }
  }

  void read_channels() {
    for (const auto& [channel, components] : document_.channels) {
      const int type = components == 1 ? TINYGLTF_TYPE_SCALAR : components;  // a vector's type is its length
      auto values = read_numbers(primitive_.attributes, channel, type, float_or_small, false);
      if (!values.empty()) mesh_.channels.push_back({channel, components, std::move(values)});
    }
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
    for (anim::MorphDelta& delta : mesh_.morph_deltas) {
      delta.position = glm::vec3(linear * glm::dvec3(delta.position));
      if (mesh_.normals.empty()) continue;
      const double length = glm::length(cofactors * glm::dvec3(mesh_.normals[delta.vertex]));
      if (length > 0.0) delta.normal = glm::vec3(cofactors * glm::dvec3(delta.normal) * (side / length));
    }
    for (glm::vec3& normal : mesh_.normals) {
      const glm::dvec3 turned = cofactors * glm::dvec3(normal) * side;
      const double length = glm::length(turned);
      normal = length > 0.0 ? glm::vec3(turned / length) : glm::vec3(0.0F);
    }
    for (glm::vec4& tangent : mesh_.tangents) {
      const glm::dvec3 turned = linear * glm::dvec3(tangent);
      const double length = glm::length(turned);
      if (length > 0.0) tangent = glm::vec4(turned / length, tangent.w * static_cast<float>(side));
    }
    if (side > 0.0) return;
    for (std::size_t i = 0; i < mesh_.indices.size(); i += 3) std::swap(mesh_.indices[i + 1], mesh_.indices[i + 2]);
  }

  void mend_normals() {
    const auto is_unit = [](const glm::vec3& normal) { return std::abs(glm::length(normal) - 1.0F) < 1e-3F; };
    if (std::ranges::all_of(mesh_.normals, is_unit)) return;
    document_.memory->charge(mesh_.positions.size() * (sizeof(glm::dvec3) + sizeof(glm::vec3)), name_);
    const auto computed = compute_normals(mesh_.positions, mesh_.indices);
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
  std::size_t bad_deltas_ = 0;
};

}  // namespace

anim::SkinnedMesh read_surface(Document& document, const tinygltf::Primitive& primitive, const MorphsOfMesh& morphs,
                               const glm::dmat4& placement, MaterialCollector& materials, const std::string& name) {
  return SurfaceReader(document, primitive, name).read(morphs, placement, materials);
}

}  // namespace throng::import
