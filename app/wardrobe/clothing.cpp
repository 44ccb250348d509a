#include "app/wardrobe/clothing.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "app/character/skin_choice.h"
#include "engine/anim/base/plain_text.h"

namespace throng::app {

namespace {

/// Returns MODEL.cast.json, if it is there.
std::filesystem::path rules_beside(const CharacterSource& source) {
  if (source.file.empty() || source.model.parts.empty()) return {};
  std::filesystem::path rules = character_file(source.file).path;
  rules.replace_extension(".cast.json");
  std::error_code ignored;
  return std::filesystem::exists(rules, ignored) ? rules : std::filesystem::path();
}

}  // namespace

anim::Result<Clothing> clothing_of(const CharacterSource& source) {
  Clothing clothing{.wardrobe = Wardrobe(source.model.parts), .rules = {}};
  const std::filesystem::path file =
      source.cast_rules.empty() ? rules_beside(source) : std::filesystem::path(source.cast_rules);
  if (file.empty()) {
    if (!clothing.wardrobe.empty()) clothing.rules = even_rules(clothing.wardrobe);
    return clothing;
  }
  auto rules = read_cast_rules(file);
  if (!rules) return rules.error();
  clothing.rules = std::move(*rules);
  if (clothing.wardrobe.empty()) return clothing;
  const std::string unknown = unknown_in(clothing.rules, clothing.wardrobe);
  if (!unknown.empty()) return anim::Error{anim::plain_text(file.string()) + ": " + unknown};
  return clothing;
}

std::vector<BodyKind> body_kinds(const CastRules& rules) {
  std::vector<BodyKind> kinds;
  for (const BodyRule& body : rules.bodies) {
    kinds.push_back({.share = static_cast<double>(body.share), .size = static_cast<double>(body.size)});
  }
  return kinds;
}

}  // namespace throng::app
