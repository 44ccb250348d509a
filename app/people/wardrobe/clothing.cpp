#include "app/people/wardrobe/clothing.h"

#include <cstddef>
#include <string>
#include <system_error>
#include <utility>

#include "app/character/skin_choice.h"
#include "app/people/wardrobe/cast_rules_text.h"
#include "app/people/wardrobe/rule_doubts.h"
#include "engine/base/text/plain_text.h"

namespace throng::app {

namespace {

constexpr std::size_t most_parts = 1000;  // each is held against the others, for each body

/// Returns MODEL.cast.json, if it is there.
std::filesystem::path rules_beside(const CharacterSource& source) {
  if (source.file.empty() || source.model.parts.empty()) return {};
  std::filesystem::path rules = character_file(source.file).path;
  rules.replace_extension(".cast.json");
  std::error_code ignored;
  return std::filesystem::exists(rules, ignored) ? rules : std::filesystem::path();
}

Result<CastRules> rules_for(const CharacterSource& source, const Wardrobe& wardrobe) {
  if (source.rules) return rules_of_text(*source.rules);
  const std::filesystem::path file = rules_file_of(source);
  if (!file.empty()) return read_cast_rules(file);
  return wardrobe.empty() ? CastRules() : even_rules(wardrobe);
}

/// Says where rules come from, for people.
std::string owner_of_rules(const CharacterSource& source) {
  return source.rules ? "the rules kept for " + source.name : plain_text(rules_file_of(source).string());
}

}  // namespace

std::filesystem::path rules_file_of(const CharacterSource& source) {
  return source.cast_rules.empty() ? rules_beside(source) : std::filesystem::path(source.cast_rules);
}

Result<Clothing> clothing_of(const CharacterSource& source) {
  if (source.model.parts.size() > most_parts) {
    return Error{plain_text(source.file) + ": it has " + std::to_string(source.model.parts.size()) +
                 " parts to wear, and " + std::to_string(most_parts) + " are the most; split the model"};
  }
  Clothing clothing{.wardrobe = Wardrobe(source.model.parts), .rules = {}, .origin = owner_of_rules(source)};
  auto rules = rules_for(source, clothing.wardrobe);
  if (!rules && source.rules) return Error{clothing.origin + ": " + rules.error().message};
  if (!rules) return rules.error();
  clothing.rules = std::move(*rules);
  const std::string wrong = wrong_for(clothing.rules, clothing.wardrobe);
  if (!wrong.empty()) return Error{clothing.origin + ": " + wrong};
  clothing.doubts = doubts_of(clothing.rules, clothing.wardrobe);
  return clothing;
}

std::string wrong_for(const CastRules& rules, const Wardrobe& wardrobe) {
  return wardrobe.empty() ? std::string() : unknown_in(rules, wardrobe);
}

std::vector<BodyKind> body_kinds(const CastRules& rules) {
  std::vector<BodyKind> kinds;
  for (const BodyRule& body : rules.bodies) {
    kinds.push_back({.share = static_cast<double>(body.share), .size = static_cast<double>(body.size)});
  }
  return kinds;
}

}  // namespace throng::app
