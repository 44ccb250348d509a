#include "app/people/wardrobe/cast_rules_text.h"

#include <array>
#include <cstdint>

#include "app/people/wardrobe/look_words.h"
#include "app/settings/option_values.h"
#include "engine/base/files/output_file.h"

namespace throng::app {
namespace {

constexpr int cast_rules_version = 1;

/// Returns the shortest number that is read as the same float, so that people see 0.8.
double shortest(float number) { return std::stod(shortest_text(number)); }

std::string color_text(std::uint32_t color) {
  constexpr std::array<char, 17> digits{"0123456789ABCDEF"};
  std::string text = "#";
  for (const unsigned shift : {4U, 0U, 12U, 8U, 20U, 16U}) text += digits.at(color >> shift & 0xFU);
  return text;
}

Json weights_json(const WeighedNames& names) {
  Json json = Json::object();
  for (const WeighedName& name : names) json[name.name] = shortest(name.weight);
  return json;
}

Json slots_json(const std::vector<SlotRule>& slots) {
  Json json = Json::object();
  for (const SlotRule& slot : slots) json[slot.slot] = weights_json(slot.parts);
  return json;
}

Json body_json(const BodyRule& body) {
  Json json = {{"share", shortest(body.share)}, {"size", shortest(body.size)}};
  if (!body.wears.empty()) json["wears"] = slots_json(body.wears);
  return json;
}

Json palette_json(const Palette& palette) {
  Json json = Json::array();
  for (const std::uint32_t color : palette.colors) json.push_back(color_text(color));
  return json;
}

Json cloth_json(const ClothRule& cloth) {
  Json json = Json::object();
  if (!cloth.colors.empty()) json["colours"] = cloth.colors;
  if (!cloth.seconds.empty()) json["seconds"] = cloth.seconds;
  for (const auto& [pattern, weight] : cloth.patterns) {
    json["patterns"][pattern_names.at(static_cast<std::size_t>(pattern))] = shortest(weight);
  }
  json["fabric"] = fabric_names.at(static_cast<std::size_t>(cloth.fabric));
  return json;
}

Json style_json(const Style& style) {
  Json json = Json::object();
  if (!style.bodies.empty()) json["bodies"] = style.bodies;
  json["wears"] = slots_json(style.wears);
  for (const auto& [slot, palette] : style.colors) json["colours"][slot] = palette;
  if (style.alike) json["alike"] = true;
  if (style.old) json["old"] = true;
  return json;
}

}  // namespace

Json to_json(const CastRules& rules) {
  Json json = {{"version", cast_rules_version}};
  for (const BodyRule& body : rules.bodies) json["bodies"][body.name] = body_json(body);
  json["skin"] = rules.skin;
  for (const Palette& palette : rules.palettes) json["colours"][palette.name] = palette_json(palette);
  for (const ClothRule& cloth : rules.clothes) json["clothes"][cloth.part] = cloth_json(cloth);
  for (const Style& style : rules.styles) json["styles"][style.name] = style_json(style);
  for (const SceneRule& scene : rules.scenes) json["scenes"][scene.scene] = weights_json(scene.styles);
  for (const WeatherRule& weather : rules.weather) json["weather"][weather.weather] = weights_json(weather.tags);
  for (const Team& team : rules.teams) {
    json["teams"].push_back(Json::array({color_text(team.color), color_text(team.second)}));
  }
  if (rules.things != 1.0F) json["things"] = shortest(rules.things);
  if (rules.seed != 0) json["seed"] = rules.seed;
  return json;
}

std::string rules_text(const CastRules& rules) { return rules.styles.empty() ? std::string() : to_json(rules).dump(); }

Result<CastRules> rules_of_text(const std::string& text) {
  if (text.empty()) return CastRules();
  const auto json = parse_json(text);
  if (!json) return json.error();
  return cast_rules(*json);
}

Status write_cast_rules(const std::filesystem::path& file, const CastRules& rules) {
  return write_whole_file(file, to_json(rules).dump(2) + "\n");
}

}  // namespace throng::app
