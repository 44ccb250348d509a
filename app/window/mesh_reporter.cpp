#include "app/window/mesh_reporter.h"

#include "app/show/painter.h"
#include "app/show/show.h"
#include "app/show/stage/stage.h"

namespace throng::app {

MeshReport report_meshes(const Show& show, std::size_t character) {
  const Stage& stage = show.stage();
  MeshReport report{
      .tolerance = mesh_tolerance(stage.tuning()), .crowd = stage.posed().mesh_choice().figures(), .lods = {}};
  for (const MeshLevel& level : show.painter().mesh_levels(character)) {
    const render::MeshError& share = stage.posed().mesh_lods().shares(character)[report.lods.size()];
    report.lods.push_back({.triangles = level.triangles,
                           .error_mm = level.error.surface * 1000.0F,
                           .face_error_mm = level.error.face * 1000.0F,
                           .below_px = fine_below(share, report.tolerance)});
  }
  if (report.lods.empty()) return report;
  const std::span<const anim::VisibleAgent> visible = stage.posed().selection().visible;
  const std::span<const std::uint8_t> chosen = stage.posed().mesh_choice().lods();
  for (std::size_t at = 0; at < visible.size(); ++at) {
    if (stage.crowd().characters()[visible[at].agent] == character) ++report.lods[chosen[at]].agents;
  }
  return report;
}

}  // namespace throng::app
