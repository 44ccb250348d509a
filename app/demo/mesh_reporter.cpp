#include "app/demo/mesh_reporter.h"

namespace throng::app {

MeshReport report_meshes(const Show& show, std::size_t character) {
  const Stage& stage = show.stage();
  MeshReport report{.tolerance = mesh_tolerance(stage.tuning()), .lods = {}};
  for (const MeshLevel& level : show.painter().mesh_levels(character)) {
    const render::MeshError& share = stage.mesh_lods().shares(character)[report.lods.size()];
    report.lods.push_back({.triangles = level.triangles,
                           .error_mm = level.error.surface * 1000.0F,
                           .face_error_mm = level.error.face * 1000.0F,
                           .below_px = fine_below(share, report.tolerance)});
  }
  if (report.lods.empty()) return report;
  for (const anim::VisibleAgent& agent : stage.selection().visible) {
    if (stage.crowd().characters()[agent.agent] != character) continue;
    ++report.lods[static_cast<std::size_t>(mesh_lod_of(stage, agent))].agents;
  }
  return report;
}

}  // namespace throng::app
