#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "throng/render/agent_look.h"

#include "app/people/crowd/character_look.h"
#include "app/people/wardrobe/cast_rules.h"
#include "app/people/wardrobe/wardrobe.h"
#include "engine/base/random.h"

namespace throng::app {

/// Says what is known of a person before it dresses.
struct Person {
  std::uint32_t agent = 0;
  std::uint8_t body = 0;    ///< index among CastRules::bodies
  std::uint32_t group = 0;  ///< people of one group like the same styles
  std::uint32_t team = 0;
  bool marches = false;          ///< in a company of one style, whose number is `group` and `team`
  bool hand_is_taken = false;    ///< by another hand, or for want of room: it holds no thing
  std::string_view brings = {};  ///< the part in the right hand, whatever the style; empty: as the style says
};

/// Holds what a person wears, and a number that is equal for people who look alike.
struct Dressed {
  render::Outfit outfit;
  const Style* style = nullptr;
  const WardrobePart* in_hand = nullptr;  ///< the thing in the right hand, or else in the left hand; null: nothing
  /// Equal for two people of one body whose top, bottom, coat and hat are the same, in patterns and colours too.
  std::uint64_t looks_like = 0;
  std::uint64_t upper_looks_like = 0;  ///< equal for the same clothes above the waist, coats and jackets included
};

/// Says what a crowd dresses for.
struct Occasion {
  std::string_view scene, weather;
  std::uint32_t seed = 0;
};

/// Draws what people wear, by rules. The same person, rules and occasion give the same clothes in any crowd.
class Dresser {
 public:
  /// `rules` and `wardrobe` outlive the dresser, and unknown_in() finds nothing in them.
  Dresser(const CastRules& rules, const Wardrobe& wardrobe, const Occasion& occasion);

  /// Dresses a person, and sets the colours of the clothes. Each attempt is another choice.
  Dressed dress(const Person& person, std::uint32_t attempt, render::AgentLook& look) const;

 private:
  struct Option {
    const WardrobePart* part;  ///< null: nothing
    float weight;
  };
  struct Slot {
    std::string name;
    std::vector<Option> options;
  };
  using Slots = std::vector<Slot>;
  struct Choice {
    const Style* style;
    float weight;              ///< of the scene
    std::vector<Slots> slots;  ///< [body]
  };
  using Choices = std::vector<Choice>;
  struct Worn;

  Choices choices_of(const SceneRule& scene, const WeatherRule* weather) const;
  Slots slots_for(const Style& style, const BodyRule& body, const WeatherRule* weather) const;

  Slot slot_for(const SlotRule& slot, const std::string& body, const WeatherRule* weather) const;
  using Silhouettes = std::array<std::array<std::uint16_t, 3>, 5>;  // pieces, by the cut around the legs and the head
  Silhouettes silhouettes_for(const std::string& body) const;
  const Choice& choice_of(const Person& person) const;
  void fill_slots(const Person& person, std::uint32_t attempt, const Slots& slots, Worn& worn) const;
  void cover(const Person& person, Worn& worn) const;
  std::uint16_t silhouette_of(const Person& person, const Worn& worn) const;
  static void color_silhouette(const Worn& worn, render::AgentLook& look);
  void color_part(const WardrobePart& part, const Style& style, const Person& person, Random& own,
                  render::AgentLook& look, std::uint64_t& looks_like) const;
  std::uint32_t seen_color(std::string_view palette, std::uint32_t color) const;
  std::uint32_t one_of(std::string_view palette, const Person& person, bool is_second, Random& random) const;

  const CastRules& rules_;
  const Wardrobe& wardrobe_;
  std::uint32_t seed_;
  Choices styles_, marching_;                            // of the scene, and of marchers
  std::vector<Silhouettes> silhouettes_;                 // [body]
  std::vector<std::vector<const WardrobePart*>> skin_;   // [body]
  std::vector<std::vector<std::uint32_t>> seen_colors_;  // [palette][color] distinct_colors
};

}  // namespace throng::app
