#include "app/window/panel/legend.h"

#include <algorithm>

#include "throng/render/crowd_draw.h"

#include "app/people/crowd/track_steps.h"
#include "app/settings/agent_colors.h"
#include "app/settings/option_values.h"
#include "app/window/panel/controls/numbers.h"
#include "app/window/panel/controls/plots.h"
#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

std::optional<int> count_at(const std::vector<int>& counts, int place) {
  if (counts.empty()) return std::nullopt;
  const auto at = static_cast<std::size_t>(place);
  return at < counts.size() ? counts[at] : 0;
}

// With the rule off, all agents are posed in each frame.
int largest_interval_in_force(const Tuning& tuning) {
  if (tuning.lod.rule == LodRule::off) return 1;
  return std::max(tuning.lod.largest_interval, tuning.inspection.forced_interval);
}

std::string frames_words(int from, int to) {
  if (from == to) return counted(static_cast<std::size_t>(from), "frame");
  const char* const between = to == from + 1 ? " and " : " to ";
  return std::to_string(from) + between + std::to_string(to) + " frames";
}

LegendPart intervals_legend(const FrameReport& report, const Tuning& tuning) {
  LegendPart part{.title = "Interval", .steps = {}};
  const int largest = largest_interval_in_force(tuning);
  for (int from = 1; from <= largest;) {
    int to = from;
    std::optional<int> agents = count_at(report.agents_by_interval, from - 1);
    while (to < largest && interval_color(to + 1) == interval_color(from)) {
      if (agents) *agents += count_at(report.agents_by_interval, to).value_or(0);
      ++to;
    }
    part.steps.push_back({interval_color(from), frames_words(from, to), agents});
    from = to + 1;
  }
  return part;
}

std::vector<std::string> of_shown_character(const FrameReport& report, const char* what) {
  if (report.characters.size() < 2 || report.character >= report.characters.size()) return {};
  return {std::string(what) + " of " + file_name(report.characters[report.character])};
}

LegendPart bones_legend(const FrameReport& report) {
  LegendPart part{.title = "Bones", .steps = {}, .notes = of_shown_character(report, "Bones")};
  const auto own = static_cast<int>(report.level_bone_counts.size());
  for (int level = 0; level < std::max(own, report.situation.bone_levels); ++level) {
    std::string words = "level " + std::to_string(level);
    if (level < own) {
      const int bones = report.level_bone_counts[static_cast<std::size_t>(level)];
      words += ": " + counted(static_cast<std::size_t>(bones), "bone");
    }
    part.steps.push_back({bone_level_color(level), words, count_at(report.agents_by_bone_level, level)});
  }
  return part;
}

LegendPart meshes_legend(const FrameReport& report) {
  LegendPart part{.title = "Mesh", .steps = {}, .notes = of_shown_character(report, "Triangles and agents")};
  const auto own = static_cast<int>(report.meshes.lods.size());
  for (int lod = 0; lod < std::max(own, report.situation.mesh_levels); ++lod) {
    LegendStep step{mesh_lod_color(lod), "LOD " + std::to_string(lod), std::nullopt};
    if (lod < own) {
      const MeshLodRow& row = report.meshes.lods[static_cast<std::size_t>(lod)];
      step.words += ": " + with_thousands(row.triangles) + " triangles";
      step.agents = row.agents;
    }
    part.steps.push_back(std::move(step));
  }
  return part;
}

LegendPart error_legend(const Tuning& tuning) {
  LegendPart part{.title = "Error on screen", .steps = {}};
  for (int step = 0; step < error_steps; ++step) {
    const bool is_last = step + 1 == error_steps;
    const std::string from = step > 0 ? shortest_text(error_limit(step - 1)) : "";
    const std::string words = step == 0 ? "below " + shortest_text(error_limit(0)) + " px"
                              : is_last ? from + " px or more"
                                        : from + " to " + shortest_text(error_limit(step)) + " px";
    const float inside = is_last ? error_limit(step - 1) : 0.75F * error_limit(step);
    part.steps.push_back({debug_color(tuning, {.error_px = inside}), words, std::nullopt});
  }
  part.steps.push_back({debug_color(tuning, {}), "not measured", std::nullopt});
  return part;
}

LegendRamp ramp_of(const ColorScale& scale) {
  constexpr int samples = 33;
  LegendRamp ramp;
  for (int i = 0; i < samples; ++i) ramp.colors.push_back(scale_color(static_cast<float>(i) / (samples - 1)));
  const float top = scale.top / scale.a_unit, step = round_up(0.999F * top / 5.0F);  // four ticks or a few more
  constexpr float rounding = 1.001F;
  for (int i = 0; static_cast<float>(i) * step <= top * rounding; ++i) {
    const float value = static_cast<float>(i) * step;
    const bool is_top = value * rounding >= top;
    ramp.ticks.push_back({std::min(value / top, 1.0F), shortest_text(value) + (is_top ? "+" : "")});
  }
  return ramp;
}

LegendPart measure_legend(const ColorScale& scale, const Tuning& tuning, bool is_recorded) {
  LegendPart part{.title = std::string(scale.title) + ", " + scale.unit, .steps = {}, .ramp = ramp_of(scale)};
  if (tuning.debug_view == DebugView::speed && is_recorded) {
    part.notes.push_back("mean of " + shortest_text(static_cast<float>(TrackSteps::stride_window)) + " s");
  } else if (tuning.debug_view == DebugView::density) {
    part.notes.push_back("Voronoi cells, cut off at " + shortest_text(tuning.density_cut_off) + " m");
  } else if (tuning.debug_view == DebugView::presence && !is_recorded) {
    part.notes.emplace_back("No effect: only people of a recorded crowd come and go");
  }
  return part;
}

// The selected agent has its own colour, whatever the view.
std::optional<LegendPart> characters_legend(const FrameReport& report, const Tuning& tuning) {
  if (idle_reason("debug_view", tuning, report.situation)) return std::nullopt;
  std::optional<LegendPart> part;
  if (const auto scale = color_scale(tuning)) {
    part = measure_legend(*scale, tuning, tuning.scene == Scene::tracks);
    if (report.selected) part->steps.push_back({selected_color, "selected", std::nullopt});
    return part;
  }
  switch (tuning.debug_view) {
    case DebugView::interval:
      part = intervals_legend(report, tuning);
      break;
    case DebugView::bone_level:
      part = bones_legend(report);
      break;
    case DebugView::mesh_lod:
      part = meshes_legend(report);
      break;
    case DebugView::error:
      part = error_legend(tuning);
      break;
    default:
      return std::nullopt;
  }
  if (part && report.selected) part->steps.push_back({selected_color, "selected", 1});
  return part;
}

/// Says which parts have the colours of intervals beside the characters, and how many figures are left out.
void add_interval_marks(std::vector<LegendPart>& parts, const FrameReport& report, const Tuning& tuning,
                        std::size_t heads_shown) {
  const bool rings = tuning.inspection.thresholds && !idle_reason("thresholds", tuning, report.situation);
  const bool heads = tuning.inspection.figures_above_heads;
  if (!rings && !heads) return;
  const bool has_intervals = !parts.empty() && tuning.debug_view == DebugView::interval;
  if (!has_intervals) parts.push_back(intervals_legend(report, tuning));
  LegendPart& part = parts.back();
  if (rings) part.title += heads ? ", rings" : " and rings";
  if (heads) part.title += " and heads";
  if (rings) part.notes.emplace_back("A ring: from here on outwards");
  if (!heads) return;
  part.notes.push_back(std::to_string(heads_shown) + " of " + std::to_string(report.heads.size()) +
                       " figures have room");
}

LegendPart difference_legend() {
  const auto amplification = static_cast<int>(render::difference_amplification);
  const std::string most = "off by 1/" + std::to_string(amplification) + " or more";
  return {.title = "Difference, times " + std::to_string(amplification),
          .steps = {{0xFF000000, "the same", std::nullopt},
                    {0xFF808080, "off by 1/" + std::to_string(2 * amplification) + " of full brightness", std::nullopt},
                    {0xFFFFFFFF, most, std::nullopt}}};
}

std::vector<LegendPart> viewer_legend(const ViewerReport& viewer) {
  std::vector<LegendPart> parts;
  const int bone = viewer.settings.weighed_bone;
  if (bone >= 0 && static_cast<std::size_t>(bone) < viewer.bones.size()) {
    LegendPart part{.title = "Follows " + viewer.bones[static_cast<std::size_t>(bone)], .steps = {}};
    for (const float weight : {0.0F, 0.25F, 0.5F, 0.75F, 1.0F}) {
      part.steps.push_back({weight_color(weight), as_percent(weight), std::nullopt});
    }
    parts.push_back(std::move(part));
  }
  if (viewer.settings.bounds) {
    parts.push_back({.title = "Bounds", .steps = {{bounds_color, "sphere that no pose leaves; body", std::nullopt}}});
  }
  return parts;
}

}  // namespace

std::vector<LegendPart> legend_of(const FrameReport& report, const Tuning& tuning, std::size_t heads_shown) {
  if (report.viewer) return viewer_legend(*report.viewer);
  std::vector<LegendPart> parts;
  if (auto part = characters_legend(report, tuning)) parts.push_back(std::move(*part));
  add_interval_marks(parts, report, tuning, heads_shown);
  const bool shows_difference = tuning.inspection.split == Split::difference;
  if (shows_difference && !idle_reason("split", tuning, report.situation)) parts.push_back(difference_legend());
  return parts;
}

}  // namespace throng::app
