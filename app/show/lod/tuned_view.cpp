#include "app/show/lod/tuned_view.h"

#include <algorithm>

#include "engine/anim/entity/foot_placement_entity.h"
#include "engine/anim/run/program/cost_model.h"

namespace throng::app {
namespace {

constexpr auto cost_of_placed_feet =
    static_cast<std::uint32_t>(anim::foot_placement_work * anim::CostModel{}.post_process);

LodForce lod_force(const LodInspection& inspection, std::optional<std::uint32_t> selected) {
  if (inspection.force_selected_only && !selected) return {};
  return {.interval = inspection.forced_interval,
          .bone_level = inspection.forced_bone_level,
          .agent = inspection.force_selected_only ? selected : std::nullopt};
}

}  // namespace

float pose_error_limit(const Tuning& tuning) {
  return tuning.mesh_lod < 0 ? tuning.error_px * (1.0F - mesh_share_of_error) : tuning.error_px;
}

// A budget without a limit on the error is about poses: meshes keep to their own limit.
MeshRules mesh_rules(const Tuning& tuning) {
  const bool is_limited = tuning.error_px > 0.0F;
  const float limit =
      is_limited ? std::min(tuning.mesh_error_px, tuning.error_px * mesh_share_of_error) : tuning.mesh_error_px;
  return {.tolerance = mesh_tolerance(limit),
          .lod = tuning.mesh_lod,
          .triangle_budget = static_cast<std::uint64_t>(tuning.triangle_budget)};
}

LodRules lod_rules(const Tuning& tuning) {
  LodRules rules = tuning.lod;
  rules.error_pixels = pose_error_limit(tuning);
  rules.budget_milliseconds = static_cast<double>(tuning.budget_ms);
  return rules;
}

ViewRules view_rules(const Tuning& tuning, std::optional<std::uint32_t> selected) {
  return {.lod = lod_rules(tuning), .force = lod_force(tuning.inspection, selected), .meshes = mesh_rules(tuning)};
}

ViewedCharacter viewed_character(const CharacterSource& source) {
  return {.character = source.character, .full_rate_nanoseconds = source.roles.is_prop ? 0 : cost_of_placed_feet};
}

anim::LodCharacter lod_character(const CharacterSource& source) {
  return throng::lod_character(viewed_character(source));
}

}  // namespace throng::app
