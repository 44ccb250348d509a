#include "app/people/wardrobe/dressed_crowd.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/people/wardrobe/dresser.h"
#include "app/settings/choices.h"

namespace throng::app {
namespace {

constexpr std::uint32_t most_attempts = 12, attempts_to_be_unique = 6;
constexpr std::size_t most_unique = 20'000;  // people; there are not many more looks that are told apart
constexpr float same_group = 2.2F;           // metres from a stander to the next of the list
constexpr std::uint64_t face_stream = 27, stoop_stream = 28;
constexpr std::uint32_t gray_hair[]{0xC9C5C0, 0xA8A4A0, 0xDCD9D6, 0x8E8A86};

/// Finds people who look alike.
class Lookalikes {
 public:
  explicit Lookalikes(std::span<const glm::vec3> positions) : positions_(positions) {}

  bool may_be_unique() const { return positions_.size() <= most_unique; }
  bool has(const Dressed& worn) const { return agents_.contains(worn.looks_like); }
  bool has_near(const Dressed& worn, std::uint32_t agent) const {
    return has_within(alike_reach, agents_.equal_range(worn.looks_like), agent);
  }
  /// Says whether a person beside an agent wears the same clothes above the waist.
  bool has_beside(const Dressed& worn, std::uint32_t agent) const {
    const auto [x, z] = cell_of(agent);
    for (int beside_x = x - 1; beside_x <= x + 1; ++beside_x) {
      for (int beside_z = z - 1; beside_z <= z + 1; ++beside_z) {
        if (has_within(upper_alike_reach, uppers_.equal_range(key(worn, beside_x, beside_z)), agent)) return true;
      }
    }
    return false;
  }
  void add(const Dressed& worn, std::uint32_t agent) {
    agents_.emplace(worn.looks_like, agent);
    const auto [x, z] = cell_of(agent);
    if (may_be_unique()) uppers_.emplace(key(worn, x, z), agent);
  }

 private:
  using Agents = std::unordered_multimap<std::uint64_t, std::uint32_t>;

  bool has_within(float metres, const auto& agents, std::uint32_t agent) const {
    return std::any_of(agents.first, agents.second, [&](const auto& other) {
      return glm::distance(positions_[other.second], positions_[agent]) < metres;
    });
  }
  std::pair<int, int> cell_of(std::uint32_t agent) const {
    const glm::vec3 cell = glm::floor(positions_[agent] / upper_alike_reach);
    return {static_cast<int>(cell.x), static_cast<int>(cell.z)};
  }
  static std::uint64_t key(const Dressed& worn, int x, int z) {
    constexpr std::uint64_t column = 0x9E3779B97F4A7C15ULL, row = 0xC2B2AE3D27D4EB4FULL;
    return worn.upper_looks_like ^ (static_cast<std::uint64_t>(x) * column + static_cast<std::uint64_t>(z) * row);
  }

  std::span<const glm::vec3> positions_;
  Agents agents_, uppers_;  // by Dressed::looks_like, and by Dressed::upper_looks_like and the cell of the ground
};

/// Draws until the person looks like no other, since people walk about, and no neighbour wears the same clothes above
/// the waist. Where that takes too long, it is enough that the person looks like no other near by.
Dressed dress_unlike_others(const Dresser& dresser, const Person& person, const Lookalikes& others,
                            render::AgentLook& look) {
  Dressed worn;
  for (std::uint32_t attempt = 0; attempt < most_attempts; ++attempt) {
    worn = dresser.dress(person, attempt, look);
    if (worn.style->alike) break;
    const bool is_choosy = others.may_be_unique() && attempt + 1 < attempts_to_be_unique;
    if (is_choosy && (others.has(worn) || others.has_beside(worn, person.agent))) continue;
    if (!others.has_near(worn, person.agent)) break;
  }
  return worn;
}

/// Numbers groups: an agent that stands beside the agent before it is of that agent's group.
std::vector<std::uint32_t> groups_of(const Crowd& crowd) {
  std::vector<std::uint32_t> groups;
  const std::span<const glm::vec3> places = crowd.positions();
  for (std::uint32_t agent = 0; agent < crowd.size(); ++agent) {
    const bool stands = agent > crowd.walkers().count() + crowd.marchers().count();
    const bool joins = stands && glm::distance(places[agent], places[agent - 1]) < same_group;
    groups.push_back(joins ? groups.back() : agent);
  }
  return groups;
}

/// A grown-up with a child at the left leads it by the hand.
std::vector<HeldThing> hands_of(const Crowd& crowd) {
  std::vector<HeldThing> hands(crowd.size());
  for (std::size_t walker = 1; walker < crowd.walkers().count(); ++walker) {
    const bool is_first =
        crowd.minds().habits()[walker] == Habit::accompany && crowd.minds().habits()[walker - 1] != Habit::accompany;
    if (!is_first || !is_child(crowd, walker)) continue;
    hands[walker - 1] = HeldThing::child;
    hands[walker] = HeldThing::grown_up;
  }
  return hands;
}

/// A pushchair has no room before a bench or a wall nor in a recorded crowd, and is in the way of a camera.
bool takes_no_pushchair(Habit habit) {
  return habit == Habit::rest || habit == Habit::lean || habit == Habit::sit_low || habit == Habit::pose ||
         habit == Habit::follow;
}

bool has_pushchair(const Dressed& worn) {
  return worn.in_hand != nullptr && held_named(worn.in_hand->name) == HeldThing::pushchair;
}

/// Teams have their sides of a scene.
std::uint32_t team_of(const glm::vec3& place) { return place.x < 0.0F ? 0 : 1; }

/// A marcher dresses with its company.
void fall_in(const Crowd& crowd, Person& person) {
  person.marches =
      person.agent >= crowd.walkers().count() && person.agent < crowd.walkers().count() + crowd.marchers().count();
  if (person.marches) person.group = person.team = crowd.marchers().company(person.agent - crowd.walkers().count());
}

void turn_gray(render::AgentLook& look, std::uint32_t agent, std::uint32_t seed) {
  constexpr std::uint64_t gray_stream = 25;
  Random random(seed + agent, gray_stream);
  const std::uint32_t gray = gray_hair[random.below(std::size(gray_hair))];
  look.tints.at(index_of(render::Region::hair)) = render::tint_of(faded(gray, random));
}

std::uint32_t signed_byte(float value) {
  return static_cast<std::uint8_t>(static_cast<std::int8_t>(std::lround(value * 127.0F)));
}

/// Gives clothes of any cut the colours of a shape that is seen from above.
void wear_pattern(render::AgentLook& look, const Tints& tints) {
  using enum render::Region;
  for (const render::Region upper : {top, outer, headgear}) {
    look.tints.at(index_of(upper)) = render::tint_of(tints.at(index_of(top)));
  }
  look.tints.at(index_of(bottom)) = render::tint_of(tints.at(index_of(bottom)));
}

}  // namespace

void give_face(render::AgentLook& look, std::uint32_t agent, std::uint32_t seed, bool is_child) {
  Random random(seed + agent, face_stream);
  const float reach = is_child ? 0.4F : 1.0F;
  look.face = 0;
  for (const unsigned shift : {0U, 8U, 16U, 24U}) look.face |= signed_byte(random.between(-reach, reach)) << shift;
}

void stoop(render::AgentLook& look, std::uint32_t agent, std::uint32_t seed) {
  constexpr std::uint32_t posture = 0xFF0000;
  Random random(seed + agent, stoop_stream);
  look.shape = (look.shape & ~posture) | signed_byte(random.between(0.55F, 1.0F)) << 16U;
}

DressedCrowd dress_crowd(const Crowd& crowd, std::span<const Clothing> clothing, const Tuning& tuning) {
  const Occasion occasion{.scene = word_of(tuning.scene),
                          .weather = weather_words.at(static_cast<std::size_t>(tuning.weather)),
                          .seed = tuning.seed};
  std::vector<std::optional<Dresser>> dressers(clothing.size());
  for (std::size_t i = 0; i < clothing.size(); ++i) {
    const bool dresses = !clothing[i].wardrobe.empty() && !clothing[i].rules.styles.empty();
    if (dresses) dressers[i].emplace(clothing[i].rules, clothing[i].wardrobe, occasion);
  }
  DressedCrowd dressed{.looks = crowd.looks().drawn,
                       .outfits = std::vector<render::Outfit>(crowd.size()),
                       .things = hands_of(crowd),
                       .in_hand = std::vector<std::uint16_t>(crowd.size(), render::Outfit::no_piece)};
  const std::vector<std::uint32_t> groups = groups_of(crowd);
  Lookalikes lookalikes(crowd.positions());
  for (std::uint32_t agent = 0; agent < crowd.size(); ++agent) {
    const std::optional<Dresser>& dresser = dressers[crowd.characters()[agent]];
    if (!dresser) continue;
    Person person{.agent = agent,
                  .body = crowd.looks().bodies[agent],
                  .group = groups[agent],
                  .team = team_of(crowd.positions()[agent]),
                  .hand_is_taken = dressed.things[agent] != HeldThing::nothing,
                  .brings = crowd.minds().habits()[agent] == Habit::photograph ? "camera" : ""};
    fall_in(crowd, person);
    Dressed worn = dress_unlike_others(*dresser, person, lookalikes, dressed.looks[agent]);
    if (takes_no_pushchair(crowd.minds().habits()[agent]) && has_pushchair(worn)) {
      person.hand_is_taken = true;
      worn = dress_unlike_others(*dresser, person, lookalikes, dressed.looks[agent]);
    }
    lookalikes.add(worn, agent);
    if (tuning.clothes == Clothes::pattern) wear_pattern(dressed.looks[agent], crowd.looks().tints[agent]);
    give_face(dressed.looks[agent], agent, tuning.seed, is_child(crowd, agent));
    if (worn.style->old) {
      turn_gray(dressed.looks[agent], agent, tuning.seed);
      stoop(dressed.looks[agent], agent, tuning.seed);
    }
    dressed.outfits[agent] = worn.outfit;
    if (worn.in_hand == nullptr) continue;
    dressed.things[agent] = held_named(worn.in_hand->name);
    if (dressed.things[agent] != HeldThing::nothing) dressed.in_hand[agent] = worn.in_hand->piece;
  }
  return dressed;
}

}  // namespace throng::app
