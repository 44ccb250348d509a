#include "engine/anim/import/influences.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/anim/import/accessors.h"
#include "engine/anim/import/bytes/refusal.h"

namespace throng::import {

namespace {

constexpr std::size_t kept = 4;
constexpr double sum_tolerance = 1e-2;  // 8-bit weights that were rounded one by one

struct Influence {
  std::uint32_t joint = 0;
  double weight = 0.0;
};

/// All sets of a primitive: [set][vertex][4].
struct Sets {
  std::vector<std::vector<std::uint32_t>> joints;
  std::vector<std::vector<float>> weights;
};

Sets read_sets(const Document& document, const tinygltf::Primitive& primitive, const std::string& name) {
  Sets sets;
  for (std::size_t set = 0;; ++set) {
    const auto joints = primitive.attributes.find("JOINTS_" + std::to_string(set));
    const auto weights = primitive.attributes.find("WEIGHTS_" + std::to_string(set));
    if (joints == primitive.attributes.end() || weights == primitive.attributes.end()) return sets;
    const AccessorRule indices{
        .what = name + ": " + joints->first,
        .types = {TINYGLTF_TYPE_VEC4},
        .components = {TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT},
        .raw = true};
    sets.joints.push_back(read_integers(document, joints->second, indices));
    sets.weights.push_back(read_floats(document, weights->second,
                                       {name + ": " + weights->first, {TINYGLTF_TYPE_VEC4}, float_or_unsigned}));
  }
}

void check_sets(const Sets& sets, const anim::Skin& skin, std::size_t vertex_count, const std::string& name) {
  for (std::size_t set = 0; set < sets.joints.size(); ++set) {
    if (sets.joints[set].size() != vertex_count * 4 || sets.weights[set].size() != vertex_count * 4) {
      refuse(name, "has another number of joints or weights than of positions");
    }
    const auto largest = std::ranges::max(sets.joints[set]);
    if (largest >= skin.bones.size()) {
      refuse(name, "names joint " + std::to_string(largest) + " of a skin with " + std::to_string(skin.bones.size()));
    }
  }
}

class VertexBinder {
 public:
  VertexBinder(const Sets& sets, const anim::Skin& skin) : sets_(sets), skin_(skin) {}

  void bind(std::size_t vertex, Influences& result) {
    gather(vertex);
    double sum = 0.0;
    for (const Influence& influence : influences_) sum += influence.weight;
    if (std::abs(sum - 1.0) > sum_tolerance) ++not_normalised;
    if (influences_.size() > kept && influences_[kept].weight > 0.0) ++too_many;
    influences_.resize(kept);
    sum = 0.0;
    for (const Influence& influence : influences_) sum += influence.weight;
    if (sum <= 0.0) {
      ++unbound;
      influences_.front() = {.joint = 0, .weight = 1.0};
      sum = 1.0;
    }
    for (int i = 0; i < 4; ++i) {
      const Influence& influence = influences_[static_cast<std::size_t>(i)];
      const bool used = influence.weight > 0.0;
      const int entry = skin_.palette_entries[used ? influence.joint : influences_.front().joint];
      result.palette_entries[vertex][i] = static_cast<std::uint16_t>(entry);
      result.weights[vertex][i] = static_cast<float>(influence.weight / sum);
    }
  }

  std::size_t not_normalised = 0;
  std::size_t too_many = 0;
  std::size_t unbound = 0;
  std::size_t negative = 0;
  std::size_t not_finite = 0;

 private:
  void gather(std::size_t vertex) {
    influences_.clear();
    for (std::size_t set = 0; set < sets_.joints.size(); ++set) {
      for (std::size_t i = vertex * 4; i < vertex * 4 + 4; ++i) {
        const auto weight = static_cast<double>(sets_.weights[set][i]);
        if (weight < 0.0) ++negative;
        if (!std::isfinite(weight)) ++not_finite;
        const bool counts = std::isfinite(weight) && weight > 0.0;
        influences_.push_back({.joint = sets_.joints[set][i], .weight = counts ? weight : 0.0});
      }
    }
    std::ranges::stable_sort(influences_, std::ranges::greater{}, &Influence::weight);
  }

  const Sets& sets_;
  const anim::Skin& skin_;
  std::vector<Influence> influences_;
};

void report(Document& document, const std::string& name, std::size_t count, const char* what) {
  if (count > 0) document.repairs.push_back(name + ": " + std::to_string(count) + " vertices " + what);
}

}  // namespace

Influences read_influences(Document& document, const tinygltf::Primitive& primitive, const anim::Skin& skin,
                           std::size_t vertex_count, const std::string& name) {
  const Sets sets = read_sets(document, primitive, name);
  check_sets(sets, skin, vertex_count, name);
  document.memory->charge(vertex_count * bytes_an_influence, name);
  Influences result{.palette_entries = std::vector<glm::u16vec4>(vertex_count),
                    .weights = std::vector<glm::vec4>(vertex_count)};
  VertexBinder binder(sets, skin);
  for (std::size_t vertex = 0; vertex < vertex_count; ++vertex) binder.bind(vertex, result);
  if (binder.not_finite > 0) {
    document.repairs.push_back(name + ": " + std::to_string(binder.not_finite) + " weights are not finite, taken as 0");
  }
  report(document, name, binder.negative, "with negative weights, taken as 0");
  report(document, name, binder.not_normalised, "whose weights did not sum to 1, normalised");
  report(document, name, binder.too_many, "with more than four influences, the strongest four kept");
  report(document, name, binder.unbound, "without any weight, bound to the first joint");
  return result;
}

Influences rigid_influences(int palette_entry, std::size_t vertex_count) {
  const auto entry = static_cast<std::uint16_t>(palette_entry);
  return {.palette_entries = std::vector<glm::u16vec4>(vertex_count, glm::u16vec4(entry)),
          .weights = std::vector<glm::vec4>(vertex_count, glm::vec4(1.0F, 0.0F, 0.0F, 0.0F))};
}

}  // namespace throng::import
