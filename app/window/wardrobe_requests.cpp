#include "app/window/wardrobe_requests.h"

#include <filesystem>

#include "app/people/wardrobe/cast_rules_text.h"
#include "app/people/wardrobe/clothing.h"
#include "app/settings/choices.h"
#include "app/show/stage/stage.h"

namespace throng::app {
namespace {

std::filesystem::path rules_file(const std::string& name) { return name + ".cast.json"; }

}  // namespace

SetRules tuned(const TuneRules& asked, const Stage& stage) {
  if (asked.character >= stage.people().size()) return {.character = asked.character, .rules = {}};
  CastRules rules = stage.clothing()[asked.character].rules;
  tune(rules, word_of(stage.tuning().scene), asked.tuning);
  return {.character = asked.character, .rules = rules_text(rules)};
}

Result<SetRules> saved(const SaveRules& asked, const Stage& stage, CharacterNumber character) {
  const std::filesystem::path file = rules_file(asked.rules);
  const CastRules& rules = stage.clothing()[character].rules;
  if (const Status written = write_cast_rules(file, rules); !written) return written.error();
  return SetRules{.character = character, .rules = rules_text(rules), .file = file.string()};
}

Result<SetRules> loaded(const LoadRules& asked, const Stage& stage, CharacterNumber character) {
  const std::filesystem::path file =
      asked.rules.empty() ? rules_file_of(stage.people()[character]) : rules_file(asked.rules);
  const auto rules = read_cast_rules(file);
  if (!rules) return rules.error();
  return SetRules{.character = character, .rules = rules_text(*rules), .file = file.string()};
}

}  // namespace throng::app
