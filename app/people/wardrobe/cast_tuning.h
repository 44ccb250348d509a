#pragma once

#include <cstdint>
#include <string_view>

#include "app/people/wardrobe/cast_rules.h"

namespace throng::app {

/// The values of rules that a person tunes while a scene is shown.
struct CastTuning {
  WeighedNames bodies;     ///< with their shares, in the order of the rules
  WeighedNames styles;     ///< of the scene, with their weights
  float things = 1.0F;     ///< CastRules::things
  std::uint32_t seed = 0;  ///< CastRules::seed

  friend bool operator==(const CastTuning&, const CastTuning&) = default;
};

CastTuning cast_tuning(const CastRules& rules, std::string_view scene);

/// Gives rules these values. Names that the rules lack are left out. A scene without rules of its own shares the first
/// scene's, which change then.
void tune(CastRules& rules, std::string_view scene, const CastTuning& tuning);

}  // namespace throng::app
