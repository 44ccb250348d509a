#include "app/window/wardrobe_reporter.h"

#include <algorithm>
#include <filesystem>

#include "app/people/wardrobe/clothing.h"
#include "app/settings/choices.h"
#include "app/show/report/frame_report.h"
#include "app/show/stage/stage.h"

namespace throng::app {

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
  const auto said = file.empty() ? anim::Result<CastRules>(anim::Error{}) : read_cast_rules(file);
  report.standard = cast_tuning(said ? *said : stage.clothing()[character].rules, word_of(stage.tuning().scene));
}

}  // namespace throng::app
