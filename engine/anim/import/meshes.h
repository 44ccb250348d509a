#pragma once

#include <vector>

#include "engine/anim/asset/model.h"
#include "engine/anim/import/document.h"
#include "engine/anim/import/materials.h"
#include "engine/anim/import/node_tree.h"
#include "engine/anim/import/skeleton_builder.h"

namespace throng::import {

struct Surfaces {
  std::vector<anim::SkinnedMesh> meshes;
  std::vector<anim::BakedMeshLod> mesh_lods;
};

/// Reads every primitive of the scene that is skinned to a skeleton or hangs below it, in the space of its palette, and
/// the coarser meshes that the file has for all of them. Throws Refusal.
Surfaces read_surfaces(Document& document, const NodeTree& tree, const BuiltSkeleton& skeleton,
                       MaterialCollector& materials);

}  // namespace throng::import
