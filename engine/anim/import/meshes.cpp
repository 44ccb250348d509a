#include "engine/anim/import/meshes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <utility>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/import/accessors.h"
#include "engine/anim/import/facing.h"
#include "engine/anim/import/memory/model_memory.h"
#include "engine/anim/import/reference_frames.h"
#include "engine/anim/import/refusal.h"
#include "engine/anim/import/surface.h"

namespace throng::import {

namespace {

/// Four influences a vertex, strongest first. Their weights sum to 1.
struct Influences {
  std::vector<glm::u16vec4> palette_entries;
  std::vector<glm::vec4> weights;
};

constexpr std::size_t bytes_an_influence = sizeof(glm::u16vec4) + sizeof(glm::vec4);  // of a vertex
constexpr std::size_t bytes_a_morph = 3 * sizeof(anim::Morph) + 512;  // with its name, in a vector that grows
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

/// Reads every JOINTS_n and WEIGHTS_n of a primitive. Messages and repairs call the primitive `name`. Weights that are
/// not finite count as 0, influences beyond four are dropped, weights that do not sum to 1 are normalised, and a vertex
/// without weights follows the first joint; repairs report all of this. Throws Refusal.
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

/// Binds every vertex to one palette entry.
Influences rigid_influences(int palette_entry, std::size_t vertex_count) {
  const auto entry = static_cast<std::uint16_t>(palette_entry);
  return {.palette_entries = std::vector<glm::u16vec4>(vertex_count, glm::u16vec4(entry)),
          .weights = std::vector<glm::vec4>(vertex_count, glm::vec4(1.0F, 0.0F, 0.0F, 0.0F))};
}

class MeshReader {
 public:
  MeshReader(Document& document, const NodeTree& tree, const std::vector<Animation>& animations,
             const BuiltSkeleton& skeleton, MaterialCollector& materials)
      : document_(document),
        tree_(tree),
        animations_(animations),
        built_(skeleton),
        materials_(materials),
        mirrored_entries_(mirrored_entries(skeleton.skeleton)) {}

  Surfaces read() {
    std::vector<int> skinned;
    for (int node = 0; node < tree_.size(); ++node) {
      if (is_drawn(node) && !is_part(node) && read_skinned(node)) skinned.push_back(node);
    }
    for (const AttachedMesh& attached : built_.attached) {
      if (!is_part(attached.node)) read_attached(attached);
    }
    Surfaces surfaces{.meshes = std::exchange(meshes_, {}), .mesh_lods = {}, .parts = {}, .morphs = morphs_};
    keeps_morphs_ = false;
    surfaces.parts = read_parts();
    if (!surfaces.parts.empty()) {
      add_first_parts(surfaces);
      return surfaces;
    }
    for (std::size_t lod = 0; lod < lod_count(skinned); ++lod) surfaces.mesh_lods.push_back(read_lod(skinned, lod));
    return surfaces;
  }

 private:
  bool is_drawn(int node) const { return tree_.is_drawn[static_cast<std::size_t>(node)]; }
  bool is_part(int node) const { return document_.parts.contains(node); }

  std::vector<anim::ModelPart> read_parts() {
    std::vector<anim::ModelPart> parts;
    for (int node = 0; node < tree_.size(); ++node) {
      if (!is_part(node) || !is_drawn(node)) continue;
      drawn_.clear();  // parts of several bodies may share a mesh
      if (read_skinned(node)) parts.push_back(read_part(node));
    }
    for (const AttachedMesh& attached : built_.attached) {
      if (!is_part(attached.node)) continue;
      read_attached(attached);
      parts.push_back(read_part(attached.node));
    }
    return parts;
  }

  /// Takes the meshes that were read last for those of a part.
  anim::ModelPart read_part(int node) {
    const PartNode& said = document_.parts.at(node);
    const std::string& name = source(node).name;
    anim::ModelPart part{.name = name.substr(name.find('/') + 1),
                         .slot = said.slot,
                         .body = said.body,
                         .covers = said.covers,
                         .keeps_out = said.keeps_out,
                         .tags = said.tags,
                         .meshes = std::exchange(meshes_, {}),
                         .lods = {},
                         .error = said.error};
    if (part.name.empty()) part.name = node_label(node);
    for (std::size_t lod = 0; source(node).skin >= 0 && lod < lods_of(node).size(); ++lod) {
      drawn_.clear();
      part.lods.push_back(read_lod({node}, lod));
    }
    return part;
  }

  /// Makes what no part is a part that is always worn, and adds the first part of each slot to the meshes.
  static void add_first_parts(Surfaces& surfaces) {
    std::set<std::string> filled;
    const std::string body = surfaces.parts.front().body;
    anim::ModelPart always;
    always.name = "always";
    always.meshes = surfaces.meshes;
    for (const anim::ModelPart& part : surfaces.parts) {
      if (!(part.body.empty() || part.body == body) || !filled.insert(part.slot).second) continue;
      surfaces.meshes.insert(surfaces.meshes.end(), part.meshes.begin(), part.meshes.end());
    }
    if (!always.meshes.empty()) surfaces.parts.insert(surfaces.parts.begin(), std::move(always));
  }

  const tinygltf::Node& source(int node) const { return document_.gltf.nodes[static_cast<std::size_t>(node)]; }

  const std::vector<MeshLodNode>& lods_of(int node) const {
    return document_.mesh_lods[static_cast<std::size_t>(node)];
  }

  /// Counts the LODs that all meshes of the skeleton have. A part without them would be missing in the distance.
  std::size_t lod_count(const std::vector<int>& skinned) {
    const auto count_of = [&](int node) { return lods_of(node).size(); };
    if (skinned.empty() || std::ranges::all_of(skinned, [&](int node) { return count_of(node) == 0; })) return 0;
    const std::size_t count = count_of(skinned.front());
    const bool alike = std::ranges::all_of(skinned, [&](int node) { return count_of(node) == count; });
    if (alike && built_.attached.empty()) return count;
    document_.repairs.push_back(node_label(skinned.front()) +
                                ": mesh LODs left out, because not every mesh of its skeleton has as many");
    return 0;
  }

  anim::BakedMeshLod read_lod(const std::vector<int>& skinned, std::size_t lod) {
    anim::BakedMeshLod baked;
    for (const int node : skinned) {
      const MeshLodNode& coarser = lods_of(node)[lod];
      if (source(coarser.node).mesh < 0 || source(coarser.node).skin != source(node).skin) {
        refuse(node_label(node), "its mesh LOD, " + node_label(coarser.node) + ", draws no mesh of the same skin");
      }
      read_skinned(coarser.node);
      baked.error = std::max(baked.error, coarser.error);
    }
    baked.meshes = std::exchange(meshes_, {});
    return baked;
  }

  std::string node_label(int node) const { return label("node", static_cast<std::size_t>(node), source(node).name); }

  /// Reads a node's mesh. Returns whether it draws something of the skeleton that no other node drew.
  bool read_skinned(int node) {
    const auto skin = std::ranges::find(built_.skins, source(node).skin, &anim::Skin::skin);
    const int mesh = source(node).mesh;
    if (source(node).skin < 0 || skin == built_.skins.end() || mesh < 0) return false;
    if (!drawn_.emplace(mesh, skin->skin).second) return false;  // a second node would draw it in the same place
    const MorphsOfMesh morphs = morphs_of(node);
    for_each_primitive(mesh, [&](const tinygltf::Primitive& primitive, const std::string& name) {
      if (!primitive.attributes.contains("JOINTS_0") || !primitive.attributes.contains("WEIGHTS_0")) {
        document_.repairs.push_back(name + ": has a skin, but no JOINTS_0 and WEIGHTS_0, left out");
        return;
      }
      MemoryScope scope(*document_.memory);
      anim::SkinnedMesh result = read_surface(document_, primitive, morphs, skin->bind_to_model, materials_, name);
      Influences influences = read_influences(document_, primitive, *skin, result.positions.size(), name);
      scope.keep(add(std::move(result), std::move(influences), mesh, name));
    });
    return true;
  }

  void read_attached(const AttachedMesh& attached) {
    glm::dmat4 to_palette = attached.to_bone;
    if (built_.skeleton.rigid) {
      const anim::ReferenceFrame& frame = built_.skeleton.references[static_cast<std::size_t>(attached.bone)];
      to_palette =
          anim::compose({.rotation = frame.rotation, .position = frame.origin, .scale = glm::dvec3(frame.scale)}) *
          to_palette;
    }
    const int entry = plain_palette_entry(built_.skeleton, attached.bone);
    const MorphsOfMesh morphs = morphs_of(attached.node);
    for_each_primitive(source(attached.node).mesh, [&](const tinygltf::Primitive& primitive, const std::string& name) {
      MemoryScope scope(*document_.memory);
      anim::SkinnedMesh result = read_surface(document_, primitive, morphs, to_palette, materials_, name);
      document_.memory->charge(result.positions.size() * bytes_an_influence, name);
      Influences influences = rigid_influences(entry, result.positions.size());
      scope.keep(add(std::move(result), std::move(influences), source(attached.node).mesh, name));
    });
  }

  /// Returns the weights of a node's morph targets without animation (glTF 2.0, 3.7.2.2): those of the node, else of
  /// its mesh, else none.
  const std::vector<double>& morph_weights(int node) const {
    const std::vector<double>& own = source(node).weights;
    return own.empty() ? document_.gltf.meshes[static_cast<std::size_t>(source(node).mesh)].weights : own;
  }

  /// Makes a morph of each target of the node's mesh that an animation moves.
  MorphsOfMesh morphs_of(int node) {
    MorphsOfMesh morphs{.rest_weights = morph_weights(node), .animated = {}};
    if (!keeps_morphs_) return morphs;
    const std::vector<int> targets = animated_targets(animations_, node, morphs.rest_weights);
    document_.memory->charge_for_good(targets.size() * bytes_a_morph, node_label(node));
    for (const int target : targets) {
      const auto place = static_cast<std::size_t>(target);
      const bool rests = place < morphs.rest_weights.size();
      morphs.animated.emplace_back(target, static_cast<std::uint32_t>(morphs_.size()));
      morphs_.push_back({.name = target_name(source(node).mesh, place),
                         .node = node,
                         .target = target,
                         .rest_weight = rests ? morphs.rest_weights[place] : 0.0});
    }
    return morphs;
  }

  std::string target_name(int mesh, std::size_t target) const {
    const auto index = static_cast<std::size_t>(mesh);
    const std::vector<std::string>& names = document_.target_names[index];
    return label("mesh", index, document_.gltf.meshes[index].name) + ", " +
           label("target", target, target < names.size() ? names[target] : "");
  }

  template <typename Action>
  void for_each_primitive(int mesh, const Action& action) {
    const tinygltf::Mesh& file_mesh = document_.gltf.meshes[static_cast<std::size_t>(mesh)];
    const std::string name = label("mesh", static_cast<std::size_t>(mesh), file_mesh.name);
    for (std::size_t i = 0; i < file_mesh.primitives.size(); ++i) {
      action(file_mesh.primitives[i], name + ", primitive " + std::to_string(i));
      document_.charge_repairs();
    }
  }

  /// Returns what it keeps.
  std::uint64_t add(anim::SkinnedMesh result, Influences influences, int mesh, const std::string& name) {
    if (result.indices.empty()) return 0;
    result.name = document_.gltf.meshes[static_cast<std::size_t>(mesh)].name;
    result.palette_entries = std::move(influences.palette_entries);
    result.weights = std::move(influences.weights);
    if (result.normals.empty()) {
      document_.memory->charge(flat_mesh_memory(result), name);
      shade_flat(result);
    }
    turn_mirrored_triangles(result, mirrored_entries_);
    const anim::Material& material = materials_.at(result.material);
    if (result.tangents.empty() && material.normal_texture.image >= 0) {
      const std::uint64_t elements = result.positions.size() + result.indices.size();
      document_.memory->charge(elements * bytes_of_tangents + bytes_of(result), name);
      add_tangents(result, material);
    }
    meshes_.push_back(std::move(result));
    return bytes_of(meshes_.back());
  }

  Document& document_;
  const NodeTree& tree_;
  const std::vector<Animation>& animations_;
  const BuiltSkeleton& built_;
  MaterialCollector& materials_;
  std::vector<bool> mirrored_entries_;
  std::set<std::pair<int, int>> drawn_;
  std::vector<anim::SkinnedMesh> meshes_;
  std::vector<anim::Morph> morphs_;
  bool keeps_morphs_ = true;  // parts and LODs do not morph
};

}  // namespace

Surfaces read_surfaces(Document& document, const NodeTree& tree, const std::vector<Animation>& animations,
                       const BuiltSkeleton& skeleton, MaterialCollector& materials) {
  return MeshReader(document, tree, animations, skeleton, materials).read();
}

}  // namespace throng::import
