#include "app/people/crowd/crowd_looks.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "app/people/crowd/clothes.h"
#include "app/people/crowd/parade.h"
#include "app/people/crowd/tower_view.h"
#include "engine/base/random.h"

namespace throng::app {
namespace {

constexpr float shortest = 0.90F, tallest = 1.08F;           // scale
constexpr float slowest = 0.90F, fastest = 1.10F;            // playback of agents in place
constexpr float slowest_pace = 0.94F, fastest_pace = 1.06F;  // of walkers, over the clip's own speed
constexpr float out_of_step = 0.04F;                         // of a walk cycle
constexpr double widest_in_spacings = 0.4;

constexpr std::uint64_t looks_stream = 4;
constexpr std::uint64_t variants_stream = 9;
constexpr std::uint64_t painted_stream = 11;
constexpr std::uint64_t clothes_stream = 14;
constexpr std::uint64_t bodies_stream = 20;
constexpr double beside_grown_ups = 2.2;  // metres, of a person, from a child to its grown-ups

/// The size and the colours of a body, and its shape where the body was made to have one.
struct BodyLook {
  float scale = 1.0F;
  Tints tints{};
  Variant variant{};
  std::uint32_t shade = 0;
};

/// Makes bodies differ. Streams of their own draw what not every character has, so that no other agent's draws change.
class BodyLooks {
 public:
  BodyLooks(std::uint32_t seed, const Variety& variety)
      : variety_(variety), variants_(seed, variants_stream), painted_(seed, painted_stream) {}

  /// Returns the look of the next agent, of character `number`. `scale` and `tints` were drawn for it.
  BodyLook next(const CharacterRoles& character, std::uint8_t number, float scale, const Tints& tints) {
    const Variant variant = random_variant(variants_);
    const float size = random_size(painted_);
    const std::uint32_t shade = random_shade(painted_);
    const bool is_first = !std::exchange(met_[number], true);
    if (is_first) first_tints_[number] = tints;
    if (!variety_.differs) return {1.0F, first_tints_[number], {}, 0};
    const Tints own = between(first_tints_[number], tints, variety_.tint);
    if (!character.is_painted) return {varied_size(scale, variety_.size), own, variant, 0};
    if (is_first) return {1.0F, own, variant, 0};
    return {varied_size(size, variety_.size), own, variant, weaker_shade(shade, variety_.tint)};
  }

 private:
  Variety variety_;
  Random variants_, painted_;
  std::array<bool, 256> met_{};
  std::array<Tints, 256> first_tints_{};
};

/// Gives agents bodies by their shares. A child walks or stands beside a grown-up, and goes nowhere alone.
class Bodies {
 public:
  Bodies(const CrowdLayout& layout, std::uint32_t seed, const CrowdCast& cast, const Variety& variety)
      : layout_(layout), cast_(cast), random_(seed, bodies_stream), are_asked_for_(variety.bodies && variety.differs) {}

  std::uint8_t next(std::size_t agent) {
    const std::vector<BodyKind>& kinds = cast_.of(agent).bodies;
    const float drawn = random_.unit();
    if (kinds.empty() || !are_asked_for_) return 0;
    const bool may_be_child = stands_beside_another(agent) && !last_is_child_;
    double total = 0.0;
    for (const BodyKind& kind : kinds) total += share_of(kind, may_be_child);
    double left = static_cast<double>(drawn) * total;
    std::size_t body = 0;
    while (body + 1 < kinds.size() && left >= share_of(kinds[body], may_be_child)) {
      left -= share_of(kinds[body++], may_be_child);
    }
    last_is_child_ = kinds[body].is_child();
    return static_cast<std::uint8_t>(body);
  }

 private:
  // Where children may be at all, there are more of them, so that their share of the crowd is about what was asked for.
  static double share_of(const BodyKind& kind, bool may_be_child) {
    constexpr double in_groups = 2.5;
    if (!kind.is_child()) return kind.share;
    return may_be_child ? in_groups * kind.share : 0.0;
  }

  bool stands_beside_another(std::size_t agent) const {
    const std::size_t before = layout_.walkers.size() + layout_.marchers.size();
    if (agent < layout_.walkers.size()) return layout_.company.follows(agent);
    if (agent <= before) return false;
    const StanderStart& own = layout_.standers[agent - before];
    const StanderStart& other = layout_.standers[agent - before - 1];
    const auto may_have_children = [](Habit habit) { return habit == Habit::stand_about || habit == Habit::pose; };
    return may_have_children(own.habit) && may_have_children(other.habit) &&
           glm::distance(own.position, other.position) < beside_grown_ups * cast_.spacing();
  }

  const CrowdLayout& layout_;
  const CrowdCast& cast_;
  Random random_;
  bool are_asked_for_;
  bool last_is_child_ = false;
};

std::optional<ClothesPattern> pattern_of(const CrowdLayout& layout, Scene scene, const CharacterRoles& roles,
                                         const Variety& variety) {
  if (variety.clothes != Clothes::pattern) return {};
  const std::vector<glm::dvec3> places = places_of(layout);
  return ClothesPattern(motif_of(scene, places.size()), places,
                        tower_view(scene, places.size(), roles, variety.clothes));
}

}  // namespace

void CrowdLooks::wear(std::vector<render::AgentLook> new_looks, std::vector<render::Outfit> new_outfits,
                      std::vector<std::uint16_t> new_in_hand) {
  assert(new_looks.size() == drawn.size() && new_outfits.size() == drawn.size());
  drawn = std::move(new_looks);
  outfits = std::move(new_outfits);
  in_hand = std::move(new_in_hand);
  number = render::new_looks_number();
}

std::vector<Habit> habits_of(const CrowdLayout& layout) {
  std::vector<Habit> habits(layout.walkers.size(), layout.walkers_habit);
  for (std::size_t walker = 0; walker < habits.size(); ++walker) {
    if (layout.company.follows(walker)) habits[walker] = Habit::accompany;
  }
  habits.insert(habits.end(), layout.marchers.size(), Habit::march);
  for (const StanderStart& place : layout.standers) habits.push_back(place.habit);
  return habits;
}

CrowdLooks looks_of(const CrowdLayout& layout, Scene scene, std::uint32_t seed, const CrowdCast& cast,
                    const CharacterRoles& laid_out_for, const Variety& variety) {
  const std::optional<ClothesPattern> pattern = pattern_of(layout, scene, laid_out_for, variety);
  const std::vector<Habit> habits = habits_of(layout);
  Random random(seed, looks_stream), clothes(seed, clothes_stream);
  BodyLooks bodies(seed, variety);
  Bodies kinds(layout, seed, cast, variety);
  const std::vector<glm::dvec3> places = pattern ? places_of(layout) : std::vector<glm::dvec3>();
  CrowdLooks looks;
  looks.number = render::new_looks_number();
  for (std::size_t agent = 0; agent < habits.size(); ++agent) {
    const CharacterRoles& character = cast.of(agent);
    const double radius = std::min(character.radius, widest_in_spacings * character.spacing());
    const bool marches = habits[agent] == Habit::march, walks = agent < layout.walkers.size();
    const float scale = random.between(shortest, tallest), phase = random.unit();
    const float pace = walks ? random.between(slowest_pace, fastest_pace) : random.between(slowest, fastest);
    const BodyLook body = bodies.next(character, cast.numbers()[agent], scale, random_tints(random));
    looks.bodies.push_back(kinds.next(agent));
    const auto size = character.bodies.empty() || !variety.bodies
                          ? 1.0F
                          : static_cast<float>(character.bodies[looks.bodies.back()].size);
    // Marchers have steps of one length, and a script counts on an actor's length of step.
    looks.scales.push_back(marches || habits[agent] == Habit::act ? 1.0F : body.scale * size);
    looks.radii.push_back(static_cast<float>(radius) * looks.scales.back());
    looks.paces.push_back(pace);
    looks.start_phases.push_back(phase);
    looks.tints.push_back(pattern ? pattern->at(places[agent], body.tints, clothes) : body.tints);
    looks.variants.push_back(body.variant);
    looks.shades.push_back(body.shade);
    looks.drawn.push_back(look_of(looks.tints.back(), body.variant, body.shade));
    if (!marches) continue;
    const double in_step = marcher_phase(layout.route, layout.marchers[agent - layout.walkers.size()], character);
    const double ragged = in_step + static_cast<double>(out_of_step * phase);
    looks.start_phases.back() = std::min(static_cast<float>(ragged - std::floor(ragged)), 0x1.fffffep-1F);
  }
  return looks;
}

}  // namespace throng::app
