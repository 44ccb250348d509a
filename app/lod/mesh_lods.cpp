#include "app/lod/mesh_lods.h"

#include <algorithm>

#include "engine/render/mesh/mesh_lod.h"

namespace throng::app {
float pose_error_limit(const Tuning& tuning) {
  return tuning.mesh_lod < 0 ? tuning.error_px * (1.0F - mesh_share_of_error) : tuning.error_px;
}

// A budget without a limit on the error is about poses: meshes keep to the usual limit.
float mesh_error_limit(const Tuning& tuning) {
  const float limit = tuning.error_px > 0.0F ? tuning.error_px : Tuning().error_px;
  return limit * mesh_share_of_error;
}

int MeshLods::choose(const Tuning& tuning, std::uint8_t character, float pixels_tall) const {
  const std::vector<float>& shares = shares_[character];
  if (shares.empty()) return 0;
  if (tuning.mesh_lod >= 0) return std::min(tuning.mesh_lod, static_cast<int>(shares.size()) - 1);
  const float pixels = mesh_error_limit(tuning) * times_allowed_;
  return render::pick_mesh_lod(shares, pixels / std::max(pixels_tall, 1.0F));
}

float MeshLods::error_px(std::uint8_t character, int lod, float pixels_tall) const {
  const std::vector<float>& shares = shares_[character];
  return shares.empty() ? 0.0F : shares[static_cast<std::size_t>(lod)] * pixels_tall;
}

}  // namespace throng::app
