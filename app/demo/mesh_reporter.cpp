#include "app/demo/mesh_reporter.h"

namespace throng::app {

MeshReport report_meshes(const Show& show, std::size_t character) {
  const Stage& stage = show.stage();
  MeshReport report{.tolerance = mesh_tolerance(stage.tuning()), .crowd = mesh_choice_of(stage).figures(), .lods = {}};
  for (const MeshLevel& level : show.painter().mesh_levels(character)) {
    const render::MeshError& share = stage.mesh_lods().shares(character)[report.lods.size()];
    report.lods.push_back({.triangles = level.triangles,
                           .error_mm = level.error.surface * 1000.0F,
                           .face_error_mm = level.error.face * 1000.0F,
                           .below_px = fine_below(share, report.tolerance)});
  }
  if (report.lods.empty()) return report;
  const std::span<const anim::VisibleAgent> visible = stage.selection().visible;
  const std::span<const std::uint8_t> chosen = mesh_choice_of(stage).lods();
  for (std::size_t at = 0; at < visible.size(); ++at) {
    if (stage.crowd().characters()[visible[at].agent] == character) ++report.lods[chosen[at]].agents;
  }
  return report;
}

}  // namespace throng::app
