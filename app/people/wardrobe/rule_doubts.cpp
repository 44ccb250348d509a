#include "app/people/wardrobe/rule_doubts.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string_view>
#include <utility>

#include "app/files/nearest_names.h"
#include "app/settings/choices.h"
#include "engine/base/text/joined.h"
#include "engine/base/text/plain_text.h"

namespace throng::app {
namespace {

constexpr std::string_view any_scene = "any";

bool are_all_zero(const WeighedNames& names) {
  return std::ranges::none_of(names, [](const WeighedName& each) { return each.weight > 0.0F; });
}

bool has_name(const auto& names, std::string_view name) { return std::ranges::find(names, name) != std::end(names); }

bool is_for(const Style& style, const std::string& body) {
  return style.bodies.empty() || has_name(style.bodies, body);
}

class RuleDoubts {
 public:
  RuleDoubts(const CastRules& rules, const Wardrobe& wardrobe) : rules_(rules), wardrobe_(wardrobe) {
    for (const WardrobePart& part : wardrobe.parts()) coverable_.insert(part.covers.begin(), part.covers.end());
  }

  std::vector<std::string> find() {
    doubt_bodies();
    for (const SceneRule& scene : rules_.scenes) doubt_scene(scene);
    for (const Style& style : rules_.styles) doubt_weights("style " + in_quotes(style.name), style.wears);
    doubt_clothes();
    for (const WeatherRule& weather : rules_.weather) doubt_weather(weather);
    if (!wardrobe_.empty()) doubt_slots(), doubt_skin();
    doubt_unused();
    return std::move(doubts_);
  }

 private:
  void doubt(std::string text) { doubts_.push_back(std::move(text)); }

  void doubt_bodies() {
    const auto has_share = [](const BodyRule& body) { return body.share > 0.0F; };
    if (!rules_.bodies.empty() && std::ranges::none_of(rules_.bodies, has_share)) {
      doubt("the shares of all bodies are 0, so every agent is the last one, " + in_quotes(rules_.bodies.back().name) +
            "; give a body a share above 0");
    }
    for (const BodyRule& body : rules_.bodies) doubt_weights("body " + in_quotes(body.name), body.wears);
  }

  void doubt_weights(const std::string& owner, const std::vector<SlotRule>& slots) {
    for (const SlotRule& slot : slots) {
      if (!are_all_zero(slot.parts)) continue;
      doubt(owner + " gives no part of " + in_quotes(slot.slot) +
            " a weight above 0, so no agent wears one; raise a weight, or take the slot out");
    }
  }

  void doubt_scene(const SceneRule& scene) {
    const std::string name = "scene " + in_quotes(scene.scene);
    std::vector<std::string> known(scene_words.begin(), scene_words.end());
    known.insert(known.end(), {std::string(any_scene), std::string(marching_scene)});
    if (!has_name(known, scene.scene)) {
      doubt(name + ": no scene is called that; the nearest are " + nearest_names(scene.scene, known));
    } else if (scene.scene == any_scene && &scene != &rules_.scenes.front()) {
      doubt(name + " is not the first, which is for all scenes that are not named; put it first");
    }
    const std::string first_style = in_quotes(scene.styles.front().name);
    if (are_all_zero(scene.styles)) {
      return doubt(name + ": all weights are 0, so all agents wear the first style, " + first_style +
                   "; give a style a weight above 0");
    }
    for (const BodyRule& body : rules_.bodies) {
      const auto suits = [&](const WeighedName& each) {
        return each.weight > 0.0F && is_for(*rules_.style(each.name), body.name);
      };
      if (body.share <= 0.0F || std::ranges::any_of(scene.styles, suits)) continue;
      std::string text = name + ": no style is for the body " + in_quotes(body.name);
      text.append(", which wears ").append(first_style).append(" for want of one; add a style for this body");
      doubt(std::move(text));
    }
  }

  // An author who begins with a copy of other rules may leave much unused in them, so all of it is one line.
  void doubt_unused() {
    std::set<std::string_view> worn, seen;
    for (const SceneRule& scene : rules_.scenes) {
      for (const WeighedName& style : scene.styles) worn.insert(style.name);
    }
    for (const ClothRule& cloth : rules_.clothes) seen.insert({cloth.colors, cloth.seconds});
    for (const Style& style : rules_.styles) {
      for (const auto& [slot, palette] : style.colors) seen.insert(palette);
    }
    doubt_unused(rules_.styles, worn, "no scene has the style ");
    doubt_unused(rules_.palettes, seen, "nothing has the colours ");
  }

  void doubt_unused(const auto& all, const std::set<std::string_view>& used, const char* sentence) {
    std::vector<std::string> unused;
    for (const auto& each : all) {
      if (!used.contains(each.name)) unused.push_back(in_quotes(each.name));
    }
    if (!unused.empty()) doubt(sentence + joined(unused, ", ", " or ") + "; use it, or take it out");
  }

  void doubt_clothes() {
    const std::vector<std::string> parts = wardrobe_.names();
    for (const ClothRule& cloth : rules_.clothes) {
      const std::string name = "clothes " + in_quotes(cloth.part);
      if (!wardrobe_.empty() && !wardrobe_.knows(cloth.part)) {
        doubt(name + ": no part is called that; the nearest are " + nearest_names(cloth.part, parts));
      }
      const auto is_drawn = [](const auto& pattern) { return pattern.second > 0.0F; };
      if (cloth.patterns.empty() || std::ranges::any_of(cloth.patterns, is_drawn)) continue;
      doubt(name + ": the weights of all patterns are 0, so it is plain; give a pattern a weight above 0");
    }
  }

  void doubt_weather(const WeatherRule& weather) {
    const std::string name = "weather " + in_quotes(weather.weather);
    if (!has_name(weather_words, weather.weather)) {
      doubt(name + ": no weather is called that; there are " + joined(weather_words, ", ", " and "));
    }
    for (const WeighedName& tag : weather.tags) {
      const auto has_tag = [&](const WardrobePart& part) { return part.has_tag(tag.name); };
      if (wardrobe_.empty() || std::ranges::any_of(wardrobe_.parts(), has_tag)) continue;
      doubt(name + ": no part has the tag " + in_quotes(tag.name) + "; give a part the tag, or take it out");
    }
  }

  void doubt_slots() {
    std::vector<std::string> slots;
    for (const WardrobePart& part : wardrobe_.parts()) {
      if (!part.slot.empty() && !has_name(slots, part.slot)) slots.push_back(part.slot);
    }
    const auto check = [&](const std::string& owner, const std::string& slot) {
      if (has_name(slots, slot)) return;
      doubt(owner + ": no part is for the slot " + in_quotes(slot) + "; the nearest are " + nearest_names(slot, slots));
    };
    for (const std::string& slot : rules_.skin) check("\"skin\"", slot);
    for (const Style& style : rules_.styles) {
      const std::string owner = "style " + in_quotes(style.name);
      for (const SlotRule& slot : style.wears) check(owner, slot.slot);
      for (const auto& [slot, palette] : style.colors) check(owner + ", colours", slot);
    }
    for (const BodyRule& body : rules_.bodies) {
      for (const SlotRule& slot : body.wears) check("body " + in_quotes(body.name), slot.slot);
    }
  }

  // Only the first style and body is named: one line in "skin" is the remedy for all that lack the same slots.
  void doubt_skin() {
    for (const Style& style : rules_.styles) {
      for (const BodyRule& body : rules_.bodies) {
        if (!is_for(style, body.name)) continue;
        const std::vector<std::string> lacking = lacking_slots(style, body);
        if (lacking.empty()) continue;
        return doubt("style " + in_quotes(style.name) + " leaves the body " + in_quotes(body.name) + " without " +
                     joined(lacking, ", ", " and ") + "; add them to \"skin\", or clothes that cover them");
      }
    }
  }

  /// Returns the slots, such as legs, that only one part of a body fills and clothes cover, where no part of the style
  /// fills or covers them.
  std::vector<std::string> lacking_slots(const Style& style, const BodyRule& body) const {
    std::set<std::string> seen(rules_.skin.begin(), rules_.skin.end());
    const auto wear = [&](const SlotRule& slot) {
      for (const WeighedName& named : slot.parts) {
        const WardrobePart* const part = named.weight > 0.0F ? wardrobe_.find(body.name, named.name) : nullptr;
        if (part == nullptr) continue;
        seen.insert(part->slot);
        seen.insert(part->covers.begin(), part->covers.end());
      }
    };
    std::ranges::for_each(style.wears, wear);
    for (const SlotRule& slot : body.wears) {
      if (std::ranges::find(style.wears, slot.slot, &SlotRule::slot) == style.wears.end()) wear(slot);
    }
    std::vector<std::string> lacking;
    for (const WardrobePart& part : wardrobe_.parts()) {
      if (!part.fits(body.name) || seen.contains(part.slot) || !coverable_.contains(part.slot)) continue;
      const auto fills = [&](const WardrobePart& each) { return each.slot == part.slot && each.fits(body.name); };
      if (std::ranges::count_if(wardrobe_.parts(), fills) == 1) lacking.push_back(part.slot);
    }
    return lacking;
  }

  const CastRules& rules_;
  const Wardrobe& wardrobe_;
  std::set<std::string> coverable_;  // slots that clothes cover
  std::vector<std::string> doubts_;
};

}  // namespace

std::vector<std::string> doubts_of(const CastRules& rules, const Wardrobe& wardrobe) {
  return RuleDoubts(rules, wardrobe).find();
}

}  // namespace throng::app
