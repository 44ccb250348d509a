#pragma once

#include <vector>

#include "engine/anim/asset/model.h"
#include "engine/anim/import/animations.h"
#include "engine/anim/import/document.h"
#include "engine/anim/import/materials.h"
#include "engine/anim/import/node_tree.h"
#include "engine/anim/import/skeleton_builder.h"

namespace throng::import {

struct Surfaces {
  std::vector<anim::SkinnedMesh> meshes;
  std::vector<anim::BakedMeshLod> mesh_lods;
  std::vector<anim::ModelPart> parts;
  std::vector<anim::Morph> morphs;  ///< of `meshes`; the coarser meshes have none
};

/// Reads every primitive of the scene that is skinned to a skeleton or hangs below it, in the space of its palette, and
/// the coarser meshes that the file has for all of them. Of morph targets, it keeps targets that an animation moves.
/// Where nodes are parts, they are apart from the others, and `meshes` has the first of each slot too.
/// Throws Refusal.
Surfaces read_surfaces(Document& document, const NodeTree& tree, const std::vector<Animation>& animations,
                       const BuiltSkeleton& skeleton, MaterialCollector& materials);

}  // namespace throng::import
