#include "app/wardrobe/clothing.h"

#include "engine/anim/base/plain_text.h"

namespace throng::app {

anim::Result<Clothing> clothing_of(const CharacterSource& source) {
  Clothing clothing{.wardrobe = Wardrobe(source.model.parts), .rules = {}};
  if (source.cast_rules.empty()) {
    if (!clothing.wardrobe.empty()) clothing.rules = even_rules(clothing.wardrobe);
    return clothing;
  }
  auto rules = read_cast_rules(source.cast_rules);
  if (!rules) return rules.error();
  clothing.rules = std::move(*rules);
  if (clothing.wardrobe.empty()) return clothing;
  const std::string unknown = unknown_in(clothing.rules, clothing.wardrobe);
  if (!unknown.empty()) return anim::Error{anim::plain_text(source.cast_rules) + ": " + unknown};
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
