#pragma once

#include <cstdint>
#include <vector>

#include "engine/anim/asset/model.h"

// These functions return how many bytes of memory the parts of a model take.

namespace throng::import {

template <typename Value>
std::uint64_t bytes_of(const std::vector<Value>& values) {
  return std::uint64_t{values.size()} * sizeof(Value);
}

template <typename Value>
std::uint64_t bytes_of(const anim::Track<Value>& track) {
  return bytes_of(track.times) + bytes_of(track.values);
}

std::uint64_t bytes_of(const anim::BoneTracks& tracks);
std::uint64_t bytes_of(const anim::SkinnedMesh& mesh);

// The next two return twice as much, because import copies a skeleton to try whether it is rigid.
/// Returns the bytes of a skeleton in vectors that grow; `meshes` are the meshes without skin that it carries.
std::uint64_t skeleton_memory(std::uint64_t bones, std::uint64_t meshes);
/// Returns the bytes of a skin, with its entries of the palette.
std::uint64_t skin_memory(std::uint64_t joints);

/// Returns the bytes of a clip beside its tracks.
std::uint64_t clip_memory(const anim::Clip& clip);

/// Returns the most bytes of a mesh without normals once each of its corners has a vertex of its own, with all bytes
/// on the way.
std::uint64_t flat_mesh_memory(const anim::SkinnedMesh& mesh);

}  // namespace throng::import
