#include "engine/anim/import/memory/model_memory.h"

namespace throng::import {
namespace {

constexpr std::uint64_t growth = 3;  // of a vector: the old place, and a new one of twice the size

}  // namespace

std::uint64_t bytes_of(const anim::BoneTracks& tracks) {
  return bytes_of(tracks.translation) + bytes_of(tracks.rotation) + bytes_of(tracks.scale);
}

std::uint64_t bytes_of(const anim::SkinnedMesh& mesh) {
  std::uint64_t bytes = sizeof mesh + mesh.name.size() + bytes_of(mesh.positions) + bytes_of(mesh.normals) +
                        bytes_of(mesh.tangents) + bytes_of(mesh.colors) + bytes_of(mesh.regions) +
                        bytes_of(mesh.palette_entries) + bytes_of(mesh.weights) + bytes_of(mesh.indices) +
                        bytes_of(mesh.morph_deltas);
  for (const auto& coords : mesh.texture_coords) bytes += sizeof coords + bytes_of(coords);
  for (const auto& channel : mesh.channels) bytes += sizeof channel + channel.name.size() + bytes_of(channel.values);
  return bytes;
}

std::uint64_t skeleton_memory(std::uint64_t bones, std::uint64_t meshes) {
  constexpr std::uint64_t a_bone = growth * sizeof(anim::Bone) + sizeof(anim::ReferenceFrame);
  constexpr std::uint64_t a_mesh = growth * (sizeof(glm::dmat4) + 2 * sizeof(int) + sizeof(anim::PaletteEntry));
  return 2 * (bones * a_bone + meshes * a_mesh);
}

std::uint64_t skin_memory(std::uint64_t joints) {
  constexpr std::uint64_t a_joint = sizeof(glm::dmat4) + 2 * sizeof(int) + growth * sizeof(anim::PaletteEntry);
  return 2 * (growth * sizeof(anim::Skin) + joints * a_joint);
}

std::uint64_t clip_memory(const anim::Clip& clip) {
  std::uint64_t bytes = growth * sizeof(anim::Clip) + clip.name.size();
  for (const anim::NamedDataKey& key : clip.data_keys) bytes += sizeof key + key.name.size();
  for (const anim::NamedCurve& curve : clip.curves) {
    bytes += sizeof curve + curve.name.size() + bytes_of(curve.times) + bytes_of(curve.values);
  }
  return bytes;
}

std::uint64_t flat_mesh_memory(const anim::SkinnedMesh& mesh) {
  constexpr std::uint64_t a_list = 64;  // of the copies of a vertex, on the heap
  constexpr std::uint64_t a_vertex = growth * (sizeof(std::uint32_t) + sizeof(glm::vec3));
  const std::uint64_t vertices = mesh.positions.size() + 1;
  const std::uint64_t bytes_a_vertex = (bytes_of(mesh) - bytes_of(mesh.indices)) / vertices + 1;
  return mesh.indices.size() * (bytes_a_vertex * 2 + a_vertex + a_list) + vertices * a_list;
}

}  // namespace throng::import
