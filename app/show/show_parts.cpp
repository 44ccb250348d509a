#include "app/show/show_parts.h"

#include "app/show/figures/notices.h"

namespace throng::app {

std::string notice_of(const ShowParts& show) {
  const Stage& stage = *show.stage;
  std::string notice;
  add_line(notice, show.painter->notice());
  add_line(notice, pu_notice(on_this_machine(stage.tuning().system).pus, stage.system().options().pus));
  for (const std::string& sentence : show.models.left_out) add_line(notice, sentence);
  if (stage.trajectories() != nullptr) add_line(notice, tracks_notice(*stage.trajectories()));
  if (show.live != nullptr) {
    for (const std::string& sentence : show.live->remarks()) add_line(notice, sentence);
  }
  add_line(notice, import_notice(stage.people()));
  add_line(notice, placement_notice(stage.people()));
  if (stage.tuning().wardrobe) add_line(notice, rules_notice(stage.clothing()));
  add_line(notice, local_store_notice(stage.system()));
  add_line(notice, palette_notice(stage.posed().shown()));
  add_line(notice, palette_format_notice(stage.system(), stage.people()));
  add_line(notice, stream_notice(stage.system(), stage.people()));
  return notice;
}

}  // namespace throng::app
