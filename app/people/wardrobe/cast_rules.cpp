#include "app/people/wardrobe/cast_rules.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>

#include "app/files/json_file.h"
#include "app/files/nearest_names.h"
#include "app/people/wardrobe/look_words.h"
#include "engine/base/json/json_object.h"
#include "engine/base/text/joined.h"
#include "engine/base/text/plain_text.h"

namespace throng::app {
namespace {

constexpr int rules_version = 1;
constexpr double least_size = 0.3, most_size = 2.0;
constexpr std::size_t most_colors = 1000;  // of all palettes; each is held against all before it
constexpr std::size_t most_bodies = 256;   // an agent keeps the number of its body in a byte

using RuleComplaint = std::optional<std::string>;

template <typename Rules, typename Member>
auto named(const Rules& rules, Member member, std::string_view name) {
  const auto found = std::ranges::find(rules, name, member);
  return found == rules.end() ? nullptr : &*found;
}

/// Reads `#RRGGBB`.
std::optional<std::uint32_t> color_of(const Json& json) {
  constexpr std::size_t length = 7;
  if (!json.is<std::string>()) return {};
  const auto text = json.get<std::string>();
  std::uint32_t value = 0;
  if (text.size() != length || text.front() != '#') return {};
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + length, value, 16);
  if (error != std::errc() || end != text.data() + length) return {};
  return (value & 0xFFU) << 16U | (value & 0xFF00U) | value >> 16U;
}

/// Reads the parts of a rules file, and keeps the first complaint.
class RulesReader {
 public:
  explicit RulesReader(const Json& json) : json_(json) {}

  Result<CastRules> read() {
    const JsonObject all(
        "", json_,
        {"version", "bodies", "skin", "colours", "clothes", "styles", "scenes", "weather", "teams", "things", "seed"},
        complaint_);
    all.version(rules_version);
    all.need({"bodies", "styles", "scenes"});
    all.texts("skin", rules_.skin);
    for (const Json::Member& body : all.members("bodies")) read_body(body);
    for (const Json::Member& palette : all.members("colours")) read_palette(palette);
    for (const Json::Member& cloth : all.members("clothes")) read_cloth(cloth);
    for (const Json::Member& style : all.members("styles")) read_style(style);
    for (const Json::Member& scene : all.members("scenes")) {
      rules_.scenes.push_back({scene.key, weighed("scene " + in_quotes(scene.key), scene.value)});
    }
    for (const Json::Member& weather : all.members("weather")) {
      rules_.weather.push_back({weather.key, weighed("weather " + in_quotes(weather.key), weather.value)});
    }
    for (const Json& team : all.elements("teams")) read_team(team);
    auto things = static_cast<double>(rules_.things);
    all.number("things", things, 0.0, most_things);
    rules_.things = static_cast<float>(things);
    all.whole("seed", rules_.seed, 0U, std::numeric_limits<std::uint32_t>::max());
    if (!complaint_) check_names();
    if (complaint_) return Error{*complaint_};
    return std::move(rules_);
  }

 private:
  void complain(std::string text) {
    if (!complaint_) complaint_ = std::move(text);
  }

  /// Returns the enumerator of a name; `names` stand in the order of the enumerators.
  template <typename Value>
  std::optional<Value> known(const std::string& owner, const char* kind, const auto& names, std::string_view name) {
    const auto found = std::ranges::find(names, name);
    if (found != names.end()) return static_cast<Value>(found - names.begin());
    complain(owner + ": no " + kind + " is called " + in_quotes(name) + "; there are " + joined(names, ", ", " and "));
    return {};
  }

  WeighedNames weighed(const std::string& owner, const Json& json) {
    WeighedNames names;
    if (!json.is_object()) complain(owner + " must be an object of names with weights");
    for (const Json::Member& member : json.members()) {
      const bool fits =
          member.value.is_number() && member.value.get<double>() >= 0.0 && member.value.get<double>() <= most_weight;
      if (fits) {
        names.push_back({member.key, static_cast<float>(member.value.get<double>())});
      } else {
        complain(owner + ": the weight of " + in_quotes(member.key) + " must be a number from 0 to 1000000");
      }
    }
    return names;
  }

  std::vector<SlotRule> worn_slots(const std::string& owner, const JsonObject& object) {
    std::vector<SlotRule> slots;
    for (const Json::Member& slot : object.members("wears")) {
      slots.push_back({slot.key, weighed(owner + ", " + in_quotes(slot.key), slot.value)});
    }
    return slots;
  }

  void read_body(const Json::Member& member) {
    const JsonObject object("body " + in_quotes(member.key), member.value, {"share", "size", "wears"}, complaint_);
    double share = 1.0, size = 1.0;
    object.number("share", share, 0.0, most_weight);
    object.number("size", size, least_size, most_size);
    rules_.bodies.push_back({member.key, static_cast<float>(share), static_cast<float>(size),
                             worn_slots("body " + in_quotes(member.key), object)});
  }

  void read_palette(const Json::Member& member) {
    Palette palette{member.key, {}};
    for (const Json& json : member.value.elements()) {
      if (const auto color = color_of(json)) palette.colors.push_back(*color);
    }
    colors_ += member.value.elements().size();
    if (colors_ > most_colors) complain("\"colours\" must be at most " + std::to_string(most_colors) + " in all");
    if (palette.colors.empty() || palette.colors.size() != member.value.elements().size()) {
      complain("colours " + in_quotes(member.key) + " must be an array of colours like \"#2F4A63\"");
    }
    rules_.palettes.push_back(std::move(palette));
  }

  void read_cloth(const Json::Member& member) {
    const std::string owner = "clothes " + in_quotes(member.key);
    const JsonObject object(owner, member.value, {"colours", "seconds", "patterns", "fabric"}, complaint_);
    ClothRule cloth{.part = member.key, .colors = {}, .seconds = {}, .patterns = {}};
    object.text("colours", cloth.colors);
    object.text("seconds", cloth.seconds);
    std::string fabric = fabric_names.at(static_cast<std::size_t>(cloth.fabric));
    object.text("fabric", fabric);
    cloth.fabric = known<render::Fabric>(owner, "fabric", fabric_names, fabric).value_or(cloth.fabric);
    if (object.has("patterns")) {
      for (const WeighedName& pattern : weighed(owner + ", patterns", object["patterns"])) {
        const auto found = known<render::Pattern>(owner, "pattern", pattern_names, pattern.name);
        if (found) cloth.patterns.emplace_back(*found, pattern.weight);
      }
    }
    rules_.clothes.push_back(std::move(cloth));
  }

  void read_style(const Json::Member& member) {
    const std::string owner = "style " + in_quotes(member.key);
    const JsonObject object(owner, member.value, {"bodies", "wears", "colours", "alike", "old"}, complaint_);
    object.need({"wears"});
    Style style;
    style.name = member.key;
    object.texts("bodies", style.bodies);
    object.flag("alike", style.alike);
    object.flag("old", style.old);
    style.wears = worn_slots(owner, object);
    for (const Json::Member& color : object.members("colours")) {
      if (!color.value.is<std::string>()) {
        complain(owner + ": the colours of " + in_quotes(color.key) + " must be the name of a palette");
      } else {
        style.colors.emplace_back(color.key, color.value.get<std::string>());
      }
    }
    rules_.styles.push_back(std::move(style));
  }

  void read_team(const Json& json) {
    const std::span<const Json> colors = json.elements();
    const auto first = colors.size() == 2 ? color_of(colors[0]) : std::nullopt;
    const auto second = colors.size() == 2 ? color_of(colors[1]) : std::nullopt;
    if (!first || !second) return complain("\"teams\" must be an array of pairs like [\"#C8102E\", \"#FFFFFF\"]");
    rules_.teams.push_back({*first, *second});
  }

  void check_names() {
    if (rules_.bodies.empty()) complain("\"bodies\" must name a body, as in {\"man\": {}}");
    if (rules_.bodies.size() > most_bodies) {
      complain("\"bodies\" has " + std::to_string(rules_.bodies.size()) + " bodies, and " +
               std::to_string(most_bodies) + " are the most");
    }
    if (rules_.scenes.empty()) complain("\"scenes\" must name a scene, as in {\"any\": {\"casual\": 1}}");
    for (const SceneRule& scene : rules_.scenes) {
      if (scene.styles.empty()) complain("scene " + in_quotes(scene.scene) + " must name a style");
      for (const WeighedName& style : scene.styles) {
        if (rules_.style(style.name) == nullptr) {
          complain("scene " + in_quotes(scene.scene) + ": no style is called " + in_quotes(style.name));
        }
      }
    }
    for (const ClothRule& cloth : rules_.clothes) {
      for (const std::string* palette : {&cloth.colors, &cloth.seconds}) {
        check_palette("clothes " + in_quotes(cloth.part), *palette);
      }
    }
    for (const Style& style : rules_.styles) {
      for (const auto& [slot, palette] : style.colors) check_palette("style " + in_quotes(style.name), palette);
      for (const std::string& body : style.bodies) check_body("style " + in_quotes(style.name), body);
    }
  }

  void check_palette(const std::string& owner, const std::string& name) {
    if (name.empty() || rules_.palette(name) != nullptr) return;
    if (name == team_colors && !rules_.teams.empty()) return;
    complain(owner + ": no colours are called " + in_quotes(name));
  }

  void check_body(const std::string& owner, const std::string& name) {
    if (named(rules_.bodies, &BodyRule::name, name) != nullptr) return;
    complain(owner + ": no body is called " + in_quotes(name));
  }

  const Json& json_;
  CastRules rules_;
  std::size_t colors_ = 0;  // of the palettes so far
  RuleComplaint complaint_;
};

}  // namespace

const Palette* CastRules::palette(std::string_view name) const { return named(palettes, &Palette::name, name); }
const ClothRule* CastRules::cloth(std::string_view part) const { return named(clothes, &ClothRule::part, part); }
const Style* CastRules::style(std::string_view name) const { return named(styles, &Style::name, name); }

const SceneRule* CastRules::scene(std::string_view name) const {
  const SceneRule* const own = named(scenes, &SceneRule::scene, name);
  return own == nullptr && !scenes.empty() ? &scenes.front() : own;
}

Result<CastRules> cast_rules(const Json& json) { return RulesReader(json).read(); }

Result<CastRules> read_cast_rules(const std::filesystem::path& file) {
  const JsonFile rules_file(file, {.unread = "give a file of rules like assets/cast.json",
                                   .malformed = "mend it, or begin with a copy of assets/cast.json",
                                   .wrong = "app/people/wardrobe/README.md says what rules hold"});
  const auto json = rules_file.read();
  if (!json) return json.error();
  auto rules = cast_rules(*json);
  if (!rules) return rules_file.wrong(rules.error().message);
  return rules;
}

namespace {

std::string unknown_among(const std::vector<SlotRule>& slots, const std::string& owner, const Wardrobe& wardrobe) {
  for (const SlotRule& slot : slots) {
    for (const WeighedName& part : slot.parts) {
      if (part.name == nothing_worn || wardrobe.knows(part.name)) continue;
      return owner + " wears " + in_quotes(part.name) + ", which no part is called; the nearest are " +
             nearest_names(part.name, wardrobe.names());
    }
  }
  return {};
}

}  // namespace

std::string unknown_in(const CastRules& rules, const Wardrobe& wardrobe) {
  for (const Style& style : rules.styles) {
    std::string unknown = unknown_among(style.wears, "style " + in_quotes(style.name), wardrobe);
    if (!unknown.empty()) return unknown;
  }
  for (const BodyRule& body : rules.bodies) {
    std::string unknown = unknown_among(body.wears, "body " + in_quotes(body.name), wardrobe);
    if (!unknown.empty()) return unknown;
  }
  const std::vector<std::string> bodies = wardrobe.bodies();
  for (const BodyRule& body : rules.bodies) {
    if (bodies.front().empty() || std::ranges::find(bodies, body.name) != bodies.end()) continue;
    return "no part fits the body " + in_quotes(body.name);
  }
  return {};
}

CastRules even_rules(const Wardrobe& wardrobe) {
  CastRules rules;
  for (const std::string& body : wardrobe.bodies()) rules.bodies.push_back({body});
  Style style;
  style.name = "any";
  for (const WardrobePart& part : wardrobe.parts()) {
    if (part.slot == anim::silhouette_slot || part.slot.empty()) continue;
    auto slot = std::ranges::find(style.wears, part.slot, &SlotRule::slot);
    if (slot == style.wears.end()) slot = style.wears.insert(slot, {part.slot, {}});
    const bool is_listed = std::ranges::find(slot->parts, part.name, &WeighedName::name) != slot->parts.end();
    if (!is_listed) slot->parts.push_back({part.name});
  }
  rules.styles.push_back(std::move(style));
  rules.scenes.push_back({"any", {{"any"}}});
  return rules;
}

}  // namespace throng::app
