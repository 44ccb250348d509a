#include "engine/anim/import/meshes.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <utility>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/import/influences.h"
#include "engine/anim/import/reference_frames.h"
#include "engine/anim/import/surface.h"

namespace throng::import {

namespace {

class MeshReader {
 public:
  MeshReader(Document& document, const NodeTree& tree, const BuiltSkeleton& skeleton, MaterialCollector& materials)
      : document_(document), tree_(tree), built_(skeleton), materials_(materials) {}

  std::vector<anim::SkinnedMesh> read() {
    for (int node = 0; node < tree_.size(); ++node) {
      if (tree_.in_scene[static_cast<std::size_t>(node)]) read_skinned(node);
    }
    for (const AttachedMesh& attached : built_.attached) read_attached(attached);
    return std::move(meshes_);
  }

 private:
  const tinygltf::Node& source(int node) const { return document_.gltf.nodes[static_cast<std::size_t>(node)]; }

  void read_skinned(int node) {
    const auto skin = std::ranges::find(built_.skins, source(node).skin, &anim::Skin::skin);
    const int mesh = source(node).mesh;
    if (source(node).skin < 0 || skin == built_.skins.end() || mesh < 0) return;
    if (!drawn_.emplace(mesh, skin->skin).second) return;  // a second node would draw it in the same place
    for_each_primitive(mesh, [&](const tinygltf::Primitive& primitive, const std::string& name) {
      if (!primitive.attributes.contains("JOINTS_0") || !primitive.attributes.contains("WEIGHTS_0")) {
        document_.repairs.push_back(name + ": has a skin, but no JOINTS_0 and WEIGHTS_0, left out");
        return;
      }
      anim::SkinnedMesh result = read_surface(document_, primitive, skin->bind_to_model, materials_, name);
      Influences influences = read_influences(document_, primitive, *skin, result.positions.size(), name);
      add(std::move(result), std::move(influences), mesh);
    });
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

std::vector<anim::SkinnedMesh> read_meshes(Document& document, const NodeTree& tree, const BuiltSkeleton& skeleton,
                                           MaterialCollector& materials) {
  return MeshReader(document, tree, skeleton, materials).read();
}

}  // namespace throng::import
