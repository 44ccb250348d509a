#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "throng/render/agent_look.h"

#include "app/people/wardrobe/wardrobe.h"
#include "engine/base/json/json.h"
#include "engine/base/result.h"

namespace throng::app {

/// A name that is drawn as often as its weight says, beside others. The name "none" stands for nothing.
struct WeighedName {
  std::string name;
  float weight = 1.0F;

  friend bool operator==(const WeighedName&, const WeighedName&) = default;
};
using WeighedNames = std::vector<WeighedName>;
inline constexpr std::string_view nothing_worn = "none";

/// Colours, sRGB, red in the lowest byte.
struct Palette {
  std::string name;
  std::vector<std::uint32_t> colors;

  friend bool operator==(const Palette&, const Palette&) = default;
};

/// Says how a piece of clothing is made.
struct ClothRule {
  std::string part;
  std::string colors, seconds;                              ///< names of palettes; empty: as the style says, else white
  std::vector<std::pair<render::Pattern, float>> patterns;  ///< with weights; empty: plain
  render::Fabric fabric = render::Fabric::cotton;

  friend bool operator==(const ClothRule&, const ClothRule&) = default;
};

/// Lists the parts that may fill a slot, with weights.
struct SlotRule {
  std::string slot;
  WeighedNames parts;

  friend bool operator==(const SlotRule&, const SlotRule&) = default;
};

/// A way to dress. Slots are filled in this order; a worn part may cover others or keep them empty.
struct Style {
  std::string name;
  std::vector<std::string> bodies;  ///< that dress like this; empty: all
  std::vector<SlotRule> wears;
  std::vector<std::pair<std::string, std::string>> colors;  ///< slot, palette: stronger than the clothes' own
  bool alike = false;                                       ///< all have the same clothes and colours, as a uniform
  bool old = false;                                         ///< grey hair, and a stoop

  friend bool operator==(const Style&, const Style&) = default;
};

/// The styles of a scene, with weights.
struct SceneRule {
  std::string scene;
  WeighedNames styles;

  friend bool operator==(const SceneRule&, const SceneRule&) = default;
};

/// Multiplies the weights of parts with a tag in some weather.
struct WeatherRule {
  std::string weather;
  WeighedNames tags;

  friend bool operator==(const WeatherRule&, const WeatherRule&) = default;
};

/// A kind of body, and what it wears whatever its style.
struct BodyRule {
  std::string name;
  float share = 1.0F;
  float size = 1.0F;                 ///< over the file's
  std::vector<SlotRule> wears = {};  ///< with any style that says nothing of the slot, such as hair

  friend bool operator==(const BodyRule&, const BodyRule&) = default;
};

/// First and second colours of a team.
struct Team {
  std::uint32_t color = 0, second = 0;

  friend bool operator==(const Team&, const Team&) = default;
};

/// Says what people wear, as `assets/cast.json` and files of users do. app/people/wardrobe/README.md has an example.
struct CastRules {
  std::vector<BodyRule> bodies;
  std::vector<std::string> skin;  ///< slots that each agent fills with the first part there is, unless it is covered
  std::vector<Palette> palettes;
  std::vector<ClothRule> clothes;
  std::vector<Style> styles;
  std::vector<SceneRule> scenes;  ///< the first is for scenes that have none of their own
  std::vector<WeatherRule> weather;
  std::vector<Team> teams;
  float things = 1.0F;     ///< how much more often hands hold a thing than the weights of styles say
  std::uint32_t seed = 0;  ///< another seed dresses all agents anew

  friend bool operator==(const CastRules&, const CastRules&) = default;

  const Palette* palette(std::string_view name) const;
  const ClothRule* cloth(std::string_view part) const;
  const Style* style(std::string_view name) const;
  /// Returns the styles of a scene, or the styles of all scenes without any.
  const SceneRule* scene(std::string_view name) const;
};

inline constexpr double most_things = 100.0;  ///< of CastRules::things
inline constexpr double most_weight = 1e6;    ///< of a name

/// The scene whose styles marching companies wear; where rules have no scene of this name, they dress like the others.
inline constexpr std::string_view marching_scene = "marchers";

/// The name that stands in a style for the colours of the agent's team.
inline constexpr std::string_view team_colors = "team";

/// Reads rules. The error names the file, the object and what to do.
Result<CastRules> read_cast_rules(const std::filesystem::path& file);

/// Returns rules out of JSON. The error is the end of a sentence that begins with the file's name.
Result<CastRules> cast_rules(const Json& json);

/// Returns a complaint about a part or body in the rules that a wardrobe lacks; an empty text if it lacks none.
std::string unknown_in(const CastRules& rules, const Wardrobe& wardrobe);

/// Returns rules for a wardrobe that has none: each agent fills each slot with any part that fits, all equally often.
CastRules even_rules(const Wardrobe& wardrobe);

}  // namespace throng::app
