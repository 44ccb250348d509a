#include "app/people/wardrobe/dresser.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "app/people/wardrobe/distinct_colors.h"

namespace throng::app {
namespace {

constexpr std::uint64_t style_stream = 21, clothes_stream = 22, uniform_stream = 23, color_stream = 24;
constexpr float share_of_alike_styles = 0.7F;  // of a group
constexpr std::uint32_t white = 0xFFFFFF;
constexpr std::uint32_t other_seeds = 0x9E3779B1U;  // from an attempt's seed to the next

/// The regions that the parts of a slot are coloured as.
constexpr std::array<std::pair<std::string_view, render::Region>, 8> regions{{{"top", render::Region::top},
                                                                              {"bottom", render::Region::bottom},
                                                                              {"outer", render::Region::outer},
                                                                              {"shoes", render::Region::shoes},
                                                                              {"headgear", render::Region::headgear},
                                                                              {"back", render::Region::thing},
                                                                              {"hand_left", render::Region::thing},
                                                                              {"hand_right", render::Region::thing}}};

// The words in names of silhouettes. A cut that hides more of the legs, or of the hair, comes later and wins.
constexpr std::array<const char*, 5> cuts{"trousers", "shorts", "skirt", "long", "coat"};
constexpr std::array<const char*, 3> heads{"short", "long", "hat"};

std::optional<render::Region> region_of(std::string_view slot) {
  const auto found = std::ranges::find(regions, slot, [](const auto& each) { return each.first; });
  if (found == regions.end()) return {};
  return found->second;
}

/// Draws by weight; null where nothing has any.
template <typename Weighed, typename Weight>
const Weighed* weighed_one(const std::vector<Weighed>& all, Weight weight, Random& random) {
  float total = 0.0F;
  for (const Weighed& each : all) total += weight(each);
  float left = random.unit() * total;
  const Weighed* last = nullptr;
  for (const Weighed& each : all) {
    if (weight(each) <= 0.0F) continue;
    last = &each;
    left -= weight(each);
    if (left < 0.0F) break;
  }
  return last;
}

/// Draws for one agent or group, so that no other's draws change anything.
Random draws_of(std::uint32_t seed, std::uint64_t number, std::uint64_t stream) {
  constexpr std::uint64_t spread = 0x9E3779B97F4A7C15ULL;
  return Random(seed + (number + 1) * spread, stream);
}

std::uint64_t mixed(std::uint64_t hash, std::uint64_t value) {
  constexpr std::uint64_t prime = 0x100000001B3ULL;
  return (hash ^ value) * prime;
}

std::uint64_t mixed(std::uint64_t hash, std::string_view text) {
  for (const char letter : text) hash = mixed(hash, static_cast<std::uint64_t>(static_cast<unsigned char>(letter)));
  return hash;
}

/// Says whether the part in a slot tells people apart. Shoes, hair and bags are too small for that.
bool is_seen_first(std::string_view slot) {
  return slot == "top" || slot == "bottom" || slot == "outer" || slot == "headgear";
}

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

}  // namespace

/// Holds what a person has chosen so far.
struct Dresser::Worn {
  const Style* style = nullptr;
  std::vector<const WardrobePart*> parts;

  bool fills(std::string_view slot) const {
    return std::ranges::any_of(parts, [&](const WardrobePart* part) { return part->slot == slot; });
  }
  bool keeps_out(std::string_view slot) const {
    return std::ranges::any_of(parts, [&](const WardrobePart* part) { return contains(part->keeps_out, slot); });
  }
  bool covers(std::string_view slot) const {
    return std::ranges::any_of(
        parts, [&](const WardrobePart* part) { return part->slot != slot && contains(part->covers, slot); });
  }
  bool has_tag(std::string_view slot, std::string_view tag) const {
    return std::ranges::any_of(parts,
                               [&](const WardrobePart* part) { return part->slot == slot && part->has_tag(tag); });
  }
  /// Says whether the part around the legs has this cut.
  bool is_cut(std::string_view tag) const {
    return has_tag("bottom", tag) || has_tag("top", tag) || has_tag("outer", tag);
  }
  bool suits(const WardrobePart& part) const {
    return std::ranges::none_of(part.keeps_out, [&](const std::string& slot) { return fills(slot); });
  }
};

Dresser::Dresser(const CastRules& rules, const Wardrobe& wardrobe, const Occasion& occasion)
    : rules_(rules), wardrobe_(wardrobe), seed_(occasion.seed + rules.seed * other_seeds) {
  const auto weather = std::ranges::find(rules.weather, occasion.weather, &WeatherRule::weather);
  const WeatherRule* const factors = weather == rules.weather.end() ? nullptr : &*weather;
  const auto marching = std::ranges::find(rules.scenes, marching_scene, &SceneRule::scene);
  styles_ = choices_of(*rules.scene(occasion.scene), factors);
  marching_ = marching == rules.scenes.end() ? styles_ : choices_of(*marching, factors);
  for (const Palette& palette : rules.palettes) seen_colors_.push_back(distinct_colors(palette));
  for (const BodyRule& body : rules.bodies) {
    silhouettes_.push_back(silhouettes_for(body.name));
    std::vector<const WardrobePart*>& skin = skin_.emplace_back();
    for (const WardrobePart& part : wardrobe.parts()) {
      if (!part.fits(body.name)) continue;
      const bool is_first = std::ranges::find(skin, part.slot, &WardrobePart::slot) == skin.end();
      if (part.slot.empty() || (contains(rules.skin, part.slot) && is_first)) skin.push_back(&part);
    }
  }
}

Dresser::Choices Dresser::choices_of(const SceneRule& scene, const WeatherRule* weather) const {
  Choices choices;
  for (const WeighedName& named : scene.styles) {
    const Style& style = *rules_.style(named.name);
    Choice& choice = choices.emplace_back(Choice{&style, named.weight, {}});
    for (const BodyRule& body : rules_.bodies) choice.slots.push_back(slots_for(style, body, weather));
  }
  return choices;
}

Dresser::Slots Dresser::slots_for(const Style& style, const BodyRule& body, const WeatherRule* weather) const {
  Slots slots;
  for (const SlotRule& slot : style.wears) slots.push_back(slot_for(slot, body.name, weather));
  for (const SlotRule& slot : body.wears) {
    const bool is_said = std::ranges::find(style.wears, slot.slot, &SlotRule::slot) != style.wears.end();
    if (!is_said) slots.push_back(slot_for(slot, body.name, weather));
  }
  return slots;
}

Dresser::Slot Dresser::slot_for(const SlotRule& slot, const std::string& body, const WeatherRule* weather) const {
  Slot filled{.name = slot.slot, .options = {}};
  for (const WeighedName& named : slot.parts) {
    const WardrobePart* const part = wardrobe_.find(body, named.name);
    if (part == nullptr && named.name != nothing_worn) continue;
    float weight = named.weight;
    if (part != nullptr && slot.slot.starts_with("hand_")) weight *= rules_.things;
    for (std::size_t i = 0; part != nullptr && weather != nullptr && i < weather->tags.size(); ++i) {
      if (part->has_tag(weather->tags[i].name)) weight *= weather->tags[i].weight;
    }
    filled.options.push_back({part, weight});
  }
  return filled;
}

const Dresser::Choice& Dresser::choice_of(const Person& person) const {
  const std::string& body = rules_.bodies[person.body].name;
  const auto weight = [&](const Choice& choice) {
    return choice.style->bodies.empty() || contains(choice.style->bodies, body) ? choice.weight : 0.0F;
  };
  const Choices& choices = person.marches ? marching_ : styles_;
  Random own = draws_of(seed_, person.agent, style_stream);
  Random of_group = draws_of(seed_, person.group, style_stream + 16);
  const bool as_group = person.marches || own.chance(share_of_alike_styles);
  const Choice* const found = weighed_one(choices, weight, as_group ? of_group : own);
  return found == nullptr ? choices.front() : *found;
}

void Dresser::fill_slots(const Person& person, std::uint32_t attempt, const Slots& slots, Worn& worn) const {
  Random own = draws_of(seed_ + attempt, person.agent, clothes_stream);
  Random uniform(seed_, uniform_stream);
  const bool is_said = person.hand_is_taken || !person.brings.empty();
  for (const Slot& slot : slots) {
    if (worn.keeps_out(slot.name) || (is_said && slot.name.starts_with("hand_"))) continue;
    const bool is_uniform = worn.style->alike && region_of(slot.name).has_value();
    const auto weight = [&](const Option& option) {
      return option.part == nullptr || worn.suits(*option.part) ? option.weight : 0.0F;
    };
    const Option* const chosen = weighed_one(slot.options, weight, is_uniform ? uniform : own);
    if (chosen != nullptr && chosen->part != nullptr) worn.parts.push_back(chosen->part);
  }
  const WardrobePart* const brought = wardrobe_.find(rules_.bodies[person.body].name, person.brings);
  if (brought != nullptr) worn.parts.push_back(brought);
}

// Parts that others cover are not drawn, such as skin below a shirt and hair below a helmet.
void Dresser::cover(const Person& person, Worn& worn) const {
  std::vector<const WardrobePart*> seen;
  for (const WardrobePart* part : skin_[person.body]) {
    if (part->slot.empty() || (!worn.covers(part->slot) && !worn.fills(part->slot))) seen.push_back(part);
  }
  for (const WardrobePart* part : worn.parts) {
    if (!worn.covers(part->slot)) seen.push_back(part);
  }
  worn.parts = std::move(seen);
}

Dresser::Silhouettes Dresser::silhouettes_for(const std::string& body) const {
  Silhouettes all{};
  for (std::size_t cut = 0; cut < cuts.size(); ++cut) {
    for (std::size_t head = 0; head < heads.size(); ++head) {
      const std::string name = std::string(anim::silhouette_slot) + "/" + cuts.at(cut) + "/" + heads.at(head);
      const WardrobePart* const found = wardrobe_.find(body, name);
      const std::uint16_t otherwise = cut == 0 ? render::Outfit::no_piece : all.at(cut - 1).at(head);
      all.at(cut).at(head) = found == nullptr ? otherwise : found->piece;
    }
  }
  return all;
}

std::uint16_t Dresser::silhouette_of(const Person& person, const Worn& worn) const {
  std::size_t cut = cuts.size() - 1;
  while (cut > 0 && !worn.is_cut(cuts.at(cut))) --cut;
  const std::size_t head = worn.fills("headgear") ? 2 : worn.has_tag("hair", heads[1]) ? 1 : 0;
  return silhouettes_[person.body].at(cut).at(head);
}

std::uint32_t Dresser::one_of(std::string_view palette, const Person& person, bool is_second, Random& random) const {
  if (palette == team_colors && !rules_.teams.empty()) {
    const Team& team = rules_.teams[person.team % rules_.teams.size()];
    return is_second ? team.second : team.color;
  }
  const Palette* const found = rules_.palette(palette);
  if (found == nullptr) return white;
  return found->colors[random.below(static_cast<std::uint32_t>(found->colors.size()))];
}

void Dresser::color_part(const WardrobePart& part, const Style& style, const Person& person, Random& own,
                         render::AgentLook& look, std::uint64_t& looks_like) const {
  const auto region = region_of(part.slot);
  if (!region) return;
  const std::size_t at = index_of(*region);
  // A draw for each region, so that a uniform has the same colours whatever else its wearer has on.
  Random uniform = draws_of(seed_ + static_cast<std::uint32_t>(at), person.team, color_stream + 16);
  Random& random = style.alike ? uniform : own;
  const ClothRule* const rule = rules_.cloth(part.name);
  const auto stronger = std::ranges::find(style.colors, part.slot, [](const auto& each) { return each.first; });
  const std::string_view first = stronger != style.colors.end() ? std::string_view(stronger->second)
                                 : rule != nullptr              ? std::string_view(rule->colors)
                                                                : std::string_view();
  const std::string_view second = first == team_colors ? first
                                  : rule != nullptr    ? std::string_view(rule->seconds)
                                                       : std::string_view();
  const std::uint32_t color = one_of(first, person, false, random);
  std::uint32_t other = one_of(second.empty() ? first : second, person, true, random);
  if (other == color) other = white;
  render::Pattern pattern = render::Pattern::plain;
  if (rule != nullptr && !rule->patterns.empty()) {
    const auto* const drawn = weighed_one(
        rule->patterns, [](const auto& each) { return each.second; }, random);
    if (drawn != nullptr) pattern = drawn->first;
  }
  constexpr std::uint32_t smallest = 90, sizes = 90;  // of patterns; 128 is the usual one
  const std::uint32_t size = smallest + random.below(sizes);
  look.tints.at(at) = render::tint_of(style.alike ? color : faded(color, random), pattern,
                                      rule == nullptr ? render::Fabric::cotton : rule->fabric);
  look.seconds.at(at) = render::second_of(other, size);
  looks_like = mixed(mixed(looks_like, seen_color(first, color)), static_cast<std::uint64_t>(pattern));
}

/// Silhouettes have an outermost layer of any kind above the waist, and legs below.
void Dresser::color_silhouette(const Worn& worn, render::AgentLook& look) {
  const auto copy = [&](render::Region from, render::Region to) {
    look.tints.at(index_of(to)) = look.tints.at(index_of(from));
    look.seconds.at(index_of(to)) = look.seconds.at(index_of(from));
  };
  if (!worn.fills("outer")) copy(render::Region::top, render::Region::outer);
  if (worn.fills("top") && !worn.fills("bottom")) copy(render::Region::top, render::Region::bottom);
}

/// Returns the first colour of the palette that people do not tell from this one.
std::uint32_t Dresser::seen_color(std::string_view palette, std::uint32_t color) const {
  const Palette* const found = rules_.palette(palette);
  if (found == nullptr) return color;
  const auto at = static_cast<std::size_t>(std::ranges::find(found->colors, color) - found->colors.begin());
  const std::vector<std::uint32_t>& seen = seen_colors_[static_cast<std::size_t>(found - rules_.palettes.data())];
  return at < seen.size() ? seen[at] : color;
}

Dressed Dresser::dress(const Person& person, std::uint32_t attempt, render::AgentLook& look) const {
  const Choice& choice = choice_of(person);
  Worn worn{.style = choice.style, .parts = {}};
  fill_slots(person, attempt, choice.slots[person.body], worn);
  cover(person, worn);
  Dressed dressed{.outfit = {}, .style = worn.style};
  Random own = draws_of(seed_ + attempt, person.agent, color_stream);
  constexpr std::uint64_t basis = 0xCBF29CE484222325ULL;
  dressed.looks_like = mixed(basis, person.body);
  dressed.upper_looks_like = basis;
  for (const WardrobePart* part : worn.parts) {
    if (dressed.outfit.count == render::Outfit::most_pieces) break;
    dressed.outfit.pieces.at(dressed.outfit.count++) = drawn_piece(*part, worn.parts);
    if (part->slot == "hand_right" || (part->slot == "hand_left" && dressed.in_hand == nullptr)) dressed.in_hand = part;
    std::uint64_t seen = mixed(basis, part->name);
    color_part(*part, *worn.style, person, own, look, seen);
    if (is_seen_first(part->slot)) dressed.looks_like = mixed(dressed.looks_like, seen);
    const bool is_upper = part->slot == "top" || part->slot == "outer";
    if (is_upper) dressed.upper_looks_like = mixed(dressed.upper_looks_like, seen);
  }
  std::ranges::sort(std::span(dressed.outfit.pieces).first(dressed.outfit.count));
  dressed.outfit.silhouette = silhouette_of(person, worn);
  color_silhouette(worn, look);
  return dressed;
}

}  // namespace throng::app
