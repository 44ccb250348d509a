#include "app/people/wardrobe/cast_tuning.h"

#include <algorithm>

namespace throng::app {

CastTuning cast_tuning(const CastRules& rules, std::string_view scene) {
  CastTuning tuning{.bodies = {}, .styles = {}, .things = rules.things, .seed = rules.seed};
  for (const BodyRule& body : rules.bodies) tuning.bodies.push_back({body.name, body.share});
  if (const SceneRule* const found = rules.scene(scene); found != nullptr) tuning.styles = found->styles;
  return tuning;
}

void tune(CastRules& rules, std::string_view scene, const CastTuning& tuning) {
  for (BodyRule& body : rules.bodies) {
    const auto wanted = std::ranges::find(tuning.bodies, body.name, &WeighedName::name);
    if (wanted != tuning.bodies.end()) body.share = wanted->weight;
  }
  const SceneRule* const found = rules.scene(scene);
  if (found != nullptr) {
    for (WeighedName& style : rules.scenes[static_cast<std::size_t>(found - rules.scenes.data())].styles) {
      const auto wanted = std::ranges::find(tuning.styles, style.name, &WeighedName::name);
      if (wanted != tuning.styles.end()) style.weight = wanted->weight;
    }
  }
  rules.things = tuning.things;
  rules.seed = tuning.seed;
}

}  // namespace throng::app
