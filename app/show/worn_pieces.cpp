#include "app/show/worn_pieces.h"

namespace throng::app {

std::vector<std::uint32_t> triangles_of_worn(const Stage& stage, std::size_t character, const render::CrowdMesh& mesh) {
  const std::vector<render::Outfit>& outfits = stage.crowd().looks().outfits;
  std::vector<std::uint64_t> sums(mesh.lod_count(), 0);
  std::uint64_t agents = 0;
  for (std::size_t agent = 0; agent < outfits.size(); ++agent) {
    if (stage.crowd().characters()[agent] != character) continue;
    ++agents;
    for (std::uint32_t lod = 0; lod < sums.size(); ++lod) {
      for_each_worn(outfits[agent], lod, [&](std::uint32_t piece) { sums[lod] += mesh.triangles(piece, lod); });
    }
  }
  std::vector<std::uint32_t> means;
  for (std::size_t lod = 0; lod < sums.size(); ++lod) {
    means.push_back(agents == 0 ? mesh.triangles(0, lod) : static_cast<std::uint32_t>(sums[lod] / agents));
  }
  return means;
}

}  // namespace throng::app
