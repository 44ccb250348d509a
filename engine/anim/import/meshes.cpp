#include "engine/anim/import/meshes.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <utility>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/import/influences.h"
#include "engine/anim/import/reference_frames.h"
#include "engine/anim/import/refusal.h"
#include "engine/anim/import/surface.h"

namespace throng::import {

namespace {

class MeshReader {
 public:
  MeshReader(Document& document, const NodeTree& tree, const BuiltSkeleton& skeleton, MaterialCollector& materials)
      : document_(document), tree_(tree), built_(skeleton), materials_(materials) {}

  Surfaces read() {
    std::vector<int> skinned;
    for (int node = 0; node < tree_.size(); ++node) {
      if (tree_.in_scene[static_cast<std::size_t>(node)] && read_skinned(node)) skinned.push_back(node);
    }
    for (const AttachedMesh& attached : built_.attached) read_attached(attached);
    Surfaces surfaces{.meshes = std::exchange(meshes_, {}), .mesh_lods = {}};
    for (std::size_t lod = 0; lod < lod_count(skinned); ++lod) surfaces.mesh_lods.push_back(read_lod(skinned, lod));
    return surfaces;
  }

 private:
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
        throw Refusal(node_label(node) + ": its mesh LOD, " + node_label(coarser.node) +
                      ", draws no mesh of the same skin; export the file again");
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
    for_each_primitive(mesh, [&](const tinygltf::Primitive& primitive, const std::string& name) {
      if (!primitive.attributes.contains("JOINTS_0") || !primitive.attributes.contains("WEIGHTS_0")) {
        document_.repairs.push_back(name + ": has a skin, but no JOINTS_0 and WEIGHTS_0, left out");
        return;
      }
      anim::SkinnedMesh result = read_surface(document_, primitive, skin->bind_to_model, materials_, name);
      Influences influences = read_influences(document_, primitive, *skin, result.positions.size(), name);
      add(std::move(result), std::move(influences), mesh);
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
    for_each_primitive(source(attached.node).mesh, [&](const tinygltf::Primitive& primitive, const std::string& name) {
      anim::SkinnedMesh result = read_surface(document_, primitive, to_palette, materials_, name);
      Influences influences = rigid_influences(entry, result.positions.size());
      add(std::move(result), std::move(influences), source(attached.node).mesh);
    });
  }

  template <typename Action>
  void for_each_primitive(int mesh, const Action& action) {
    const tinygltf::Mesh& file_mesh = document_.gltf.meshes[static_cast<std::size_t>(mesh)];
    const std::string name = label("mesh", static_cast<std::size_t>(mesh), file_mesh.name);
    for (std::size_t i = 0; i < file_mesh.primitives.size(); ++i) {
      action(file_mesh.primitives[i], name + ", primitive " + std::to_string(i));
    }
  }

  void add(anim::SkinnedMesh result, Influences influences, int mesh) {
    if (result.indices.empty()) return;
    result.name = document_.gltf.meshes[static_cast<std::size_t>(mesh)].name;
    result.palette_entries = std::move(influences.palette_entries);
    result.weights = std::move(influences.weights);
    meshes_.push_back(std::move(result));
  }

  Document& document_;
  const NodeTree& tree_;
  const BuiltSkeleton& built_;
  MaterialCollector& materials_;
  std::set<std::pair<int, int>> drawn_;
  std::vector<anim::SkinnedMesh> meshes_;
};

}  // namespace

Surfaces read_surfaces(Document& document, const NodeTree& tree, const BuiltSkeleton& skeleton,
                       MaterialCollector& materials) {
  return MeshReader(document, tree, skeleton, materials).read();
}

}  // namespace throng::import
