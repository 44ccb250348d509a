#include "engine/crowd/mesh_lods.h"

#include <algorithm>
#include <cmath>

namespace throng {
namespace {

// A lost face is seen as much as a surface that is three times as far off.
constexpr float face_weight = 3.0F;

float height_for(float share, float pixels) { return share > 0.0F ? pixels / share : INFINITY; }

}  // namespace

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

int MeshLods::choose(const MeshRules& rules, std::uint8_t character, float pixels_tall) const {
  const std::vector<render::MeshError>& shares = shares_[character];
  if (shares.empty()) return 0;
  if (rules.lod >= 0) return std::min(rules.lod, static_cast<int>(shares.size()) - 1);
  const MeshTolerance& allowed = rules.tolerance;
  const float tall = std::max(pixels_tall, 1.0F), face = tall < least_face_pixels ? allowed.surface : allowed.face;
  return render::pick_mesh_lod(shares, {.surface = allowed.surface / tall, .face = face / tall});
}

float MeshLods::seen_px(const MeshRules& rules, std::uint8_t character, int lod, float pixels_tall) const {
  const render::MeshError& share = shares_[character][static_cast<std::size_t>(lod)];
  const MeshTolerance& allowed = rules.tolerance;
  const float off = std::max(share.surface, share.face) * pixels_tall;
  const bool loses_face = pixels_tall >= least_face_pixels && share.face * pixels_tall > allowed.face;
  return loses_face ? std::max(off, allowed.surface) * face_weight : off;
}

std::size_t MeshLods::first_below(const MeshRules& rules, std::size_t people, float pixels_tall,
                                  std::size_t lods) const {
  if (rules.lod >= 0 || rules.triangle_budget > 0) return lods;  // these may show any LOD near by
  const MeshTolerance& allowed = rules.tolerance;
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

}  // namespace throng
