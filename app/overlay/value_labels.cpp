#include "app/overlay/value_labels.h"

#include <algorithm>
#include <array>

namespace throng::app {
namespace {

struct ValueLabel {
  std::string_view key, label;
};

constexpr std::array value_labels = std::to_array<ValueLabel>({
    {"scene", "Scene"},
    {"agents", "Agents"},
    {"seed", "Seed"},
    {"variety", "Variety"},
    {"tint", "Tint"},
    {"size_variety", "Size variety"},
    {"time_scale", "Speed"},
    {"placed_feet", "Placed feet"},
    {"lod", "Rule"},
    {"full_rate_distance", "Full rate until"},
    {"interval_growth", "Interval step"},
    {"largest_interval", "Largest interval"},
    {"error_sample", "Measure"},
    {"error_px", "Error limit"},
    {"budget_ms", "Time limit"},
    {"smooth", "Smooth"},
    {"bone_lod", "Per-bone LOD"},
    {"bone_level_distance_1", "Level 1 from"},
    {"bone_level_distance_2", "Level 2 from"},
    {"bone_level_distance_3", "Level 3 from"},
    {"mesh_lod", "Mesh LOD"},
    {"mesh_error_px", "Mesh error"},
    {"pus", "PUs"},
    {"local_store_kib", "Local store"},
    {"tile", "Tile"},
    {"schedule", "Schedule"},
    {"double_buffer", "Double buffer"},
    {"stream", "Stream"},
    {"palette", "Palette"},
    {"debug_view", "Colours"},
    {"bones_as_lines", "Bones as lines"},
    {"cost_least_task_ns", "Grain"},
});

}  // namespace

std::string label_of(std::string_view key) {
  const auto* const found = std::ranges::find(value_labels, key, &ValueLabel::key);
  std::string label(found == value_labels.end() ? key : found->label);
  std::ranges::replace(label, '_', ' ');
  return label;
}

}  // namespace throng::app
