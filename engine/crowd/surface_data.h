#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "throng/render/crowd_mesh_data.h"

#include "engine/anim/asset/model.h"
#include "engine/anim/asset/skeleton.h"

/// Describes a model's surface as drawing takes it. Spans point into the model.
namespace throng {

/// Describes a mesh, with the coordinates that the textures of its material read.
render::MeshPartData part_data(const anim::SkinnedMesh& mesh, const anim::Material& material);

void add_materials(std::span<const anim::Material> materials, std::span<const anim::Image> images,
                   render::CrowdMeshData& data);

/// Adds what a vertex reads at each bone level, and the frames that unpack palettes.
void add_palette_data(const anim::Skeleton& skeleton, render::CrowdMeshData& data);

/// Returns the changes that morphs make to the surface of these meshes.
std::vector<render::MorphDeltaData> morph_deltas(std::span<const anim::SkinnedMesh> meshes);

/// Returns for each palette entry whether it moves the head; nothing where no bone is the head for certain.
std::vector<std::uint8_t> face_entries(const anim::Skeleton& skeleton);

/// Returns the ends of the lines that show bones, two a bone.
std::vector<render::BoneEndData> bone_ends(const anim::Skeleton& skeleton);

}  // namespace throng
