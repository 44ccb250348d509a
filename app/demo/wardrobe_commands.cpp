#include "app/demo/wardrobe_commands.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/settings/choices.h"
#include "app/wardrobe/cast_rules_text.h"
#include "app/wardrobe/clothing.h"
#include "engine/anim/base/plain_text.h"

namespace throng::app {
namespace {

constexpr const char* rules_file_ending = ".cast.json";

std::string_view scene_of(const Stage& stage) { return scene_words.at(static_cast<std::size_t>(stage.tuning().scene)); }

void change_rules(Show& show, const NewCast& asked, Messages& messages) {
  CastRules rules = cast_rules_of(show.stage(), asked.character);
  tune(rules, scene_of(show.stage()), asked.tuning);
  messages.tell(set_cast_rules(show, asked.character, std::move(rules)));
}

bool save_rules(Show& show, std::size_t character, const std::filesystem::path& file, Messages& messages) {
  const CastRules rules = cast_rules_of(show.stage(), character);
  anim::Status saved = write_cast_rules(file, rules);
  if (saved) saved = set_cast_rules(show, character, rules, file.string());
  messages.tell(saved, "Wrote " + file.string());
  return saved.has_value();
}

bool load_rules(Show& show, std::size_t character, const std::filesystem::path& file, Messages& messages) {
  auto rules = read_cast_rules(file);
  if (!rules) return messages.say(rules.error().message, Message::Kind::refused), false;
  const anim::Status set = set_cast_rules(show, character, std::move(*rules), file.string());
  const std::string name = anim::plain_text(file.string());
  messages.tell(set ? set : anim::Status(anim::Error{name + ": " + set.error().message}), "Read " + name);
  return set.has_value();
}

}  // namespace

bool obey_wardrobe(Show& show, std::size_t character, const WardrobeCommands& commands, Messages& messages) {
  const auto file = [](const std::string& name) { return std::filesystem::path(name + rules_file_ending); };
  if (commands.cast && commands.cast->character < show.stage().people().size()) {
    change_rules(show, *commands.cast, messages);
  }
  bool is_other_file = false;
  if (commands.save) is_other_file |= save_rules(show, character, file(*commands.save), messages);
  if (commands.load) {
    const std::filesystem::path wanted =
        commands.load->empty() ? rules_file_of(show.stage().people()[character]) : file(*commands.load);
    is_other_file |= load_rules(show, character, wanted, messages);
  }
  return is_other_file;
}

void report_wardrobe(const Stage& stage, std::size_t character, WardrobeReport& report) {
  const CastRules& rules = cast_rules_of(stage, character);
  report.tuning = rules.styles.empty() ? CastTuning() : cast_tuning(rules, scene_of(stage));
  const std::span<const std::uint16_t> in_hand = stage.crowd().looks().in_hand;
  report.holding =
      static_cast<int>(in_hand.size()) - static_cast<int>(std::ranges::count(in_hand, render::Outfit::no_piece));
}

void read_standard_rules(const Stage& stage, std::size_t character, WardrobeReport& report) {
  const std::filesystem::path file = rules_file_of(stage.characters()[character]);
  report.file = file.string();
  const auto said = file.empty() ? anim::Result<CastRules>(anim::Error{}) : read_cast_rules(file);
  report.standard = cast_tuning(said ? *said : cast_rules_of(stage, character), scene_of(stage));
}

}  // namespace throng::app
