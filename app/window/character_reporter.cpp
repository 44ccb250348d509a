#include "app/window/character_reporter.h"

#include <algorithm>
#include <filesystem>

#include "app/people/wardrobe/clothing.h"
#include "app/settings/choices.h"
#include "app/show/lod/tuned_view.h"
#include "app/show/painter.h"
#include "app/show/show.h"
#include "app/show/stage/stage.h"

namespace throng::app {

MeshReport report_meshes(const Show& show, std::size_t character) {
  const Stage& stage = show.stage();
  MeshReport report{
      .tolerance = mesh_rules(stage.tuning()).tolerance, .crowd = stage.posed().mesh_choice().figures(), .lods = {}};
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

void report_wardrobe(const Stage& stage, std::size_t character, WardrobeReport& report) {
  const CastRules& rules = stage.clothing()[character].rules;
  report.tuning = rules.styles.empty() ? CastTuning() : cast_tuning(rules, word_of(stage.tuning().scene));
  const std::span<const std::uint16_t> in_hand = stage.crowd().looks().in_hand;
  report.holding =
      static_cast<int>(in_hand.size()) - static_cast<int>(std::ranges::count(in_hand, render::Outfit::no_piece));
}

void read_standard_rules(const Stage& stage, std::size_t character, WardrobeReport& report) {
  const std::filesystem::path file = rules_file_of(stage.characters()[character]);
  report.file = file.string();
  const auto said = file.empty() ? Result<CastRules>(Error{}) : read_cast_rules(file);
  report.standard = cast_tuning(said ? *said : stage.clothing()[character].rules, word_of(stage.tuning().scene));
}

}  // namespace throng::app
