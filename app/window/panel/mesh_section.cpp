// The mesh LODs of the character shown, in Per-bone LOD: the values that decide, and the levels that follow.
#include <array>
#include <cmath>
#include <string>

#include "app/settings/agent_colors.h"
#include "app/window/panel/tabs.h"

namespace throng::app {
namespace {

constexpr std::array mesh_words = {"auto", "0", "1", "2", "3", "4", "5", "6"};
static_assert(mesh_words.size() == mesh_lod_steps + 1);

std::string off_by(float value) { return fixed(value, 2) + " px"; }

std::string where_drawn(const MeshLodRow& row) {
  return std::isfinite(row.below_px) ? "below " + fixed(row.below_px, 0) + " px tall" : "near by";
}

void show_lods(const TabContext& context) {
  const MeshReport& meshes = context.report.meshes;
  const bool by_error = context.tuning.mesh_lod < 0;
  for (std::size_t lod = 0; lod < meshes.lods.size(); ++lod) {
    const MeshLodRow& row = meshes.lods[lod];
    const std::string label = "Mesh " + std::to_string(lod);
    const std::string off = "Its surface is off by " + fixed(row.error_mm, 1) + " mm at most, its face by " +
                            fixed(row.face_error_mm, 1) + " mm, as measured over its clips.";
    const std::string where = by_error ? where_drawn(row) + ": " : std::string();
    context.widgets.fact(
        label.c_str(),
        counted(row.triangles, "triangle") + ", " + where + counted(static_cast<std::size_t>(row.agents), "agent"),
        {.what = off.c_str()});
  }
}

std::string what_holds(const TabContext& context) {
  const MeshTolerance& allowed = context.report.meshes.tolerance;
  const std::string faces = "From 100 px tall on, faces are off by " + off_by(allowed.face) + " at most.";
  const bool is_less = allowed.surface < context.tuning.mesh_error_px;
  return (is_less ? "The error limit leaves " + off_by(allowed.surface) + " for meshes. " : std::string()) + faces;
}

std::string what_is_demoted(const TabContext& context) {
  const MeshFigures& crowd = context.report.meshes.crowd;
  const std::string all = counted(crowd.triangles, "triangle") + " in view";
  if (context.tuning.triangle_budget == 0 || context.tuning.mesh_lod >= 0) return all + ".";
  if (crowd.demoted == 0) return all + ", within the limit.";
  const std::string coarser = all + " instead of " + with_thousands(crowd.triangles_wanted) + ": " +
                              counted(crowd.demoted, "agent") + (crowd.demoted == 1 ? " has" : " have") +
                              " a coarser mesh, off by " + off_by(crowd.demoted_error_px) + " at most. ";
  return coarser + (crowd.budget_held ? "The limit holds." : "The limit is too low: all have their coarsest mesh.");
}

}  // namespace

void show_meshes(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, requests, memory] = context;
  widgets.section("Meshes");
  int mesh = tuning.mesh_lod + 1;
  context.unless_idle("mesh_lod", [&] {
    context.widgets.choose(tuning_value("mesh_lod").label, mesh, context.standard.mesh_lod + 1, mesh_words,
                           {.what = "auto: the coarsest mesh that keeps to the error below. A number: that one for "
                                    "all, 0 is the full mesh.",
                            .cost = "Triangles take most of the frame where the processor draws."});
  });
  tuning.mesh_lod = mesh - 1;
  const bool by_error = tuning.mesh_lod < 0;
  context.row("mesh_error_px",
              {.what = "What a coarser mesh may be off on screen. Its surface and its colours count, as measured in "
                       "poses of all clips. Half of the error limit is the most that counts.",
               .unit = "pixels",
               .cost = "A smaller error costs more triangles."});
  context.row("triangle_budget",
              {.what = "Triangles of all characters in view at most. Where the error above asks for more, agents on "
                       "whom a coarser mesh shows least get one, whatever the error.",
               .cost = "A lower limit makes meshes coarser, of far people first."});
  if (widgets.is_searching()) return;
  widgets.caption(what_is_demoted(context));
  if (by_error) widgets.caption(what_holds(context));
  show_lods(context);
}

}  // namespace throng::app
