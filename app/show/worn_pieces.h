#pragma once

#include <cstdint>
#include <vector>

#include "app/show/lod/lod_export.h"
#include "engine/render/agent_look.h"
#include "engine/render/mesh/mesh.h"

namespace throng::app {

class Stage;

/// Calls visit(piece) for each piece with which the wearer of an outfit is drawn at a mesh LOD: its pieces, or its
/// silhouette far away; without any, all of the character.
void for_each_worn(const render::Outfit& outfit, std::uint32_t mesh_lod, const auto& visit) {
  if (outfit.count == 0) return visit(std::uint32_t{0});
  const bool far = mesh_lod >= render::first_silhouette_lod;
  if (far && outfit.silhouette != render::Outfit::no_piece) return visit(std::uint32_t{outfit.silhouette});
  for (std::size_t i = 0; i < outfit.count; ++i) visit(std::uint32_t{outfit.pieces[i]});
}

/// Returns the mesh LODs of a stage's character as its agents wear it: the largest error of any piece at each, and how
/// many triangles an agent is drawn with on average. An agent changes all of its pieces at once.
std::vector<MeshLevel> worn_levels(const Stage& stage, std::size_t character, const render::CrowdMesh& mesh);

}  // namespace throng::app
