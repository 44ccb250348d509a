#include "app/character/morph_deltas.h"

#include <cstdint>

namespace throng::app {

std::vector<render::MorphDeltaData> morph_deltas(const anim::Model& model) {
  std::vector<render::MorphDeltaData> deltas;
  std::uint32_t first = 0;  // vertex of the mesh
  for (const anim::SkinnedMesh& mesh : model.meshes) {
    for (const anim::MorphDelta& delta : mesh.morph_deltas) {
      deltas.push_back({.vertex = first + delta.vertex,
                        .morph = delta.morph,
                        .position = {delta.position.x, delta.position.y, delta.position.z},
                        .normal = {delta.normal.x, delta.normal.y, delta.normal.z}});
    }
    first += static_cast<std::uint32_t>(mesh.positions.size());
  }
  return deltas;
}

}  // namespace throng::app
