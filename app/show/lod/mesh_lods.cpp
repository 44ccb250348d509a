#include "app/show/lod/mesh_lods.h"

#include <algorithm>
#include <cmath>

#include "engine/render/mesh/mesh_lod.h"

namespace throng::app {
namespace {

// A lost face is seen as much as a surface that is three times as far off.
constexpr float face_weight = 3.0F;

float height_for(float share, float pixels) { return share > 0.0F ? pixels / share : INFINITY; }

}  // namespace

float pose_error_limit(const Tuning& tuning) {
  return tuning.mesh_lod < 0 ? tuning.error_px * (1.0F - mesh_share_of_error) : tuning.error_px;
}

// A budget without a limit on the error is about poses: meshes keep to their own limit.
MeshTolerance mesh_tolerance(const Tuning& tuning) {
  const bool is_limited = tuning.error_px > 0.0F;
  const float limit =
      is_limited ? std::min(tuning.mesh_error_px, tuning.error_px * mesh_share_of_error) : tuning.mesh_error_px;
  return {.surface = limit, .face = std::min(limit, most_face_error)};
}

render::MeshError shares_of(const render::MeshError& metres, double height) {
  constexpr double least_height = 1e-6;
  const auto scale = static_cast<float>(1.0 / std::max(height, least_height));
  return {.surface = metres.surface * scale, .face = metres.face * scale};
}

float fine_below(const render::MeshError& shares, const MeshTolerance& tolerance) {
  const float surface = height_for(shares.surface, tolerance.surface);
  const float without_face = std::min({surface, height_for(shares.face, tolerance.surface), least_face_pixels});
  return std::max(without_face, std::min(surface, height_for(shares.face, tolerance.face)));
}

int MeshLods::choose(const Tuning& tuning, std::uint8_t character, float pixels_tall) const {
  const std::vector<render::MeshError>& shares = shares_[character];
  if (shares.empty()) return 0;
  if (tuning.mesh_lod >= 0) return std::min(tuning.mesh_lod, static_cast<int>(shares.size()) - 1);
  const MeshTolerance allowed = mesh_tolerance(tuning);
  const float tall = std::max(pixels_tall, 1.0F), face = tall < least_face_pixels ? allowed.surface : allowed.face;
  return render::pick_mesh_lod(shares, {.surface = allowed.surface / tall, .face = face / tall});
}

float MeshLods::seen_px(const Tuning& tuning, std::uint8_t character, int lod, float pixels_tall) const {
  const render::MeshError& share = shares_[character][static_cast<std::size_t>(lod)];
  const MeshTolerance allowed = mesh_tolerance(tuning);
  const float off = std::max(share.surface, share.face) * pixels_tall;
  const bool loses_face = pixels_tall >= least_face_pixels && share.face * pixels_tall > allowed.face;
  return loses_face ? std::max(off, allowed.surface) * face_weight : off;
}

std::size_t MeshLods::first_below(const Tuning& tuning, std::size_t people, float pixels_tall, std::size_t lods) const {
  if (tuning.mesh_lod >= 0 || tuning.triangle_budget > 0) return lods;  // these may show any LOD near by
  const MeshTolerance allowed = mesh_tolerance(tuning);
  const auto is_small = [&](std::size_t lod) {
    return std::ranges::all_of(std::span(shares_).first(people), [&](const std::vector<render::MeshError>& shares) {
      return lod >= shares.size() || fine_below(shares[lod], allowed) <= pixels_tall;
    });
  };
  std::size_t first = 1;
  while (first < lods && !is_small(first)) ++first;
  return first;
}

float MeshLods::error_px(std::uint8_t character, int lod, float pixels_tall) const {
  const std::vector<render::MeshError>& shares = shares_[character];
  return shares.empty() ? 0.0F : shares[static_cast<std::size_t>(lod)].surface * pixels_tall;
}

}  // namespace throng::app
