#include "engine/anim/import/meshes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <utility>

#include "engine/anim/asset/reference_frames.h"
#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/import/accessors.h"
#include "engine/anim/import/bytes/refusal.h"
#include "engine/anim/import/facing.h"
#include "engine/anim/import/influences.h"
#include "engine/anim/import/memory/model_memory.h"
#include "engine/anim/import/surface.h"

namespace throng::import {

namespace {

constexpr std::size_t bytes_a_morph = 3 * sizeof(anim::Morph) + 512;  // with its name, in a vector that grows

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

  /// Takes the meshes that were read last as a part's.
  anim::ModelPart read_part(int node) {
    const PartNode& described = document_.parts.at(node);
    const std::string& name = source(node).name;
    anim::ModelPart part{.name = name.substr(name.find('/') + 1),
                         .slot = described.slot,
                         .body = described.body,
                         .covers = described.covers,
                         .keeps_out = described.keeps_out,
                         .tags = described.tags,
                         .meshes = std::exchange(meshes_, {}),
                         .lods = {},
                         .error = described.error};
    if (part.name.empty()) part.name = node_label(node);
    for (std::size_t lod = 0; source(node).skin >= 0 && lod < lods_of(node).size(); ++lod) {
      drawn_.clear();
      part.lods.push_back(read_lod({node}, lod));
    }
    return part;
  }

  /// Makes meshes outside of parts a part that is always worn, and adds the first part of each slot to the meshes.
  static void add_first_parts(Surfaces& surfaces) {
    std::set<std::string> filled;
    const std::string body = surfaces.parts.front().body;
    anim::ModelPart always;
    always.name = "always";
    always.meshes = surfaces.meshes;
    for (const anim::ModelPart& part : surfaces.parts) {
      const bool fits = part.body.empty() || part.body == body;
      if (!fits || part.slot == anim::silhouette_slot || !filled.insert(part.slot).second) continue;
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

  /// Returns the bytes that it keeps.
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
