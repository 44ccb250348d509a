#pragma once

#include "throng/lod_rules.h"
#include "throng/standard.h"

namespace throng {

/// The agents in view whose error on screen is measured.
enum class ErrorSampling : std::uint8_t { some, all, off };

/// An agent of `least_face_pixels` on the screen keeps its face on any device: the face is off by `most_face_error`
/// pixels at most.
inline constexpr float least_face_pixels = 100.0F, most_face_error = 0.5F;

/// The pixels that a coarser mesh may be off, where a mesh is chosen by its error.
struct MeshTolerance {
  float surface = 0.0F;
  float face = 0.0F;  ///< of agents that are least_face_pixels tall or taller

  friend bool operator==(const MeshTolerance&, const MeshTolerance&) = default;
};
/// Returns the tolerance whose surface is off by `pixels` at most.
inline MeshTolerance mesh_tolerance(float pixels) {
  return {.surface = pixels, .face = pixels < most_face_error ? pixels : most_face_error};
}

/// How the mesh LODs of the agents in view are chosen.
struct MeshRules {
  MeshTolerance tolerance = mesh_tolerance(most_face_error);
  int lod = -1;                       ///< every agent has this mesh LOD, or its coarsest; below 0: by errors
  std::uint64_t triangle_budget = 0;  ///< of all agents in view; 0: no limit. A fixed mesh LOD has none

  bool has_budget() const { return triangle_budget > 0 && lod < 0; }
  friend bool operator==(const MeshRules&, const MeshRules&) = default;
};

/// What decides how exactly a crowd is seen.
struct ViewRules {
  LodRules lod{.smooth = true};
  LodForce force;
  MeshRules meshes;

  friend bool operator==(const ViewRules&, const ViewRules&) = default;
};

}  // namespace throng
