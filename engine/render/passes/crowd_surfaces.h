#pragma once

#include <cstddef>
#include <span>

#include "throng/render/crowd_draw.h"

#include "engine/render/mesh/mesh.h"
#include "engine/render/passes/crowd_runs.h"
#include "engine/render/passes/indirect_draws.h"

namespace throng::render {

/// Locations of uniforms, the same in every program of the crowd; CrowdMesh::bind sets 0.
enum SurfaceLocation : GLint { base_color_location = 1, alpha_cutoff_location = 2 };

/// Says whether a batch shows patterns, fabrics and faces: near pieces of outfits do.
inline bool is_dressed(const CrowdBatch& batch, std::size_t first_plain_lod) {
  return batch.piece != 0 && batch.mesh_lod < first_plain_lod;
}

/// Adds the commands of a group, which has begun: of all batches that are seen and `are_wanted`.
void add_commands(std::span<const CrowdBatch> run, const CrowdMesh& mesh, int material, IndirectDraws& draws,
                  const auto& are_wanted) {
  for (const CrowdBatch& batch : run) {
    if (batch.stands_in || !are_wanted(batch)) continue;
    for (const MaterialRun& triangles : mesh.runs(batch.piece, batch.mesh_lod)) {
      if (triangles.material == material) draws.add(triangles, batch);
    }
  }
}

/// Makes a group of each material of the crowd that `is_wanted`.
void compose_surfaces(std::span<const CrowdBatch> batches, std::span<const CrowdMesh> meshes, IndirectDraws& draws,
                      const auto& is_wanted) {
  draws.clear();
  for_each_run(batches, [&](std::span<const CrowdBatch> run) {
    const CrowdMesh& mesh = meshes[run[0].character];
    for (int material = 0; material < mesh.materials().size(); ++material) {
      if (!is_wanted(mesh.materials()[material])) continue;
      draws.begin_group(run[0].page, run[0].character, material);
      add_commands(run, mesh, material, draws, [](const CrowdBatch&) { return true; });
    }
  });
}

/// Makes a group of each material of the crowd, and one more of dressed batches.
inline void compose_dressed_surfaces(const CrowdFrame& frame, std::span<const CrowdMesh> meshes, IndirectDraws& draws) {
  draws.clear();
  for_each_run(frame.batches, [&](std::span<const CrowdBatch> run) {
    const CrowdMesh& mesh = meshes[run[0].character];
    for (int material = 0; material < mesh.materials().size(); ++material) {
      for (const bool dressed : {true, false}) {
        draws.begin_group(run[0].page, run[0].character, material, dressed);
        add_commands(run, mesh, material, draws,
                     [&](const CrowdBatch& batch) { return is_dressed(batch, frame.first_plain_lod) == dressed; });
      }
    }
  });
}

inline bool is_any(const CrowdMaterial& /*material*/) { return true; }
inline bool is_blended(const CrowdMaterial& material) { return material.coverage == Coverage::blended; }

/// Leaves out the backs of surfaces, unless a material has two sides.
inline void set_culling(const CrowdMaterial& material) {
  if (material.double_sided) {
    glDisable(GL_CULL_FACE);
  } else {
    glEnable(GL_CULL_FACE);
  }
}

}  // namespace throng::render
