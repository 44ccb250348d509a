#include "app/people/crowd/stadium.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/random.h"

namespace throng::app {
namespace {

// Metres, for a person 1.8 m tall.
constexpr double seat_pitch = 0.78;
constexpr double tier_pitch = 0.95;
constexpr double tier_rise = 0.42;
constexpr double least_corner = 4.5;  // radius of the lowest tier's corners
constexpr double lane_gap = 1.5;      // between the tiers and the outermost lane, and between lanes
constexpr double athlete_pitch = 3.0;

constexpr std::size_t agents_an_athlete = 14;
constexpr std::size_t most_athletes = 60;
constexpr double wave_speed = 11.0;  // metres a second
constexpr double least_wave_seconds = 9.0;
constexpr Ticks up_in_wave = ticks_per_second * 9 / 5;
constexpr double wave_unevenness = 0.25;  // seconds

std::size_t tier_count(std::size_t agents) {
  return static_cast<std::size_t>(std::max(1L, std::lround(std::sqrt(static_cast<double>(agents)) / 4.5)));
}

// Twice as long as wide, as large as the seats ask for.
Lane lowest_tier(std::size_t agents, const CharacterRoles& roles) {
  const double spacing = roles.spacing();
  const auto tiers = static_cast<double>(tier_count(agents));
  const double middle_radius = (least_corner + 0.5 * (tiers - 1.0) * tier_pitch) * spacing;
  const double length = static_cast<double>(agents) / tiers * seat_pitch * spacing;
  const double unit = std::max(0.0, (length - 2.0 * std::numbers::pi * middle_radius) / 12.0);
  return {{0.0, 0.0}, {2.0 * unit, unit}, least_corner * spacing, 1.0, 0.0};
}

Lane grown(Lane lane, double by) {
  lane.corner_radius += by;
  return lane;
}

std::size_t athletes_of(std::size_t agents, const CharacterRoles& roles) {
  return roles.can_walk() ? std::min(agents / agents_an_athlete, most_athletes) : 0;
}

void seat_tier(const StadiumTier& tier, CrowdLayout& layout) {
  for (std::size_t seat = 0; seat < tier.seats; ++seat) {
    const LanePoint place = stadium_seat(tier, seat);
    const double round = static_cast<double>(seat) / static_cast<double>(tier.seats);
    layout.standers.push_back({place.position, place.heading, tier.height, Habit::sit, round});
  }
}

std::vector<StadiumTier> tiers_for(std::size_t seats, const Lane& lowest, double spacing) {
  std::vector<StadiumTier> tiers;
  for (int index = 0; seats > 0; ++index) {
    const Lane lane = grown(lowest, index * tier_pitch * spacing);
    const std::size_t count = std::min(seats, static_cast<std::size_t>(lane.length() / (seat_pitch * spacing)));
    tiers.push_back({lane, count, index * tier_rise * spacing});
    seats -= count;
  }
  return tiers;
}

void add_athletes(std::size_t wanted, const Lane& tier, double spacing, Random random, CrowdLayout& layout) {
  for (int lane = 1; lane <= 2; ++lane) layout.lanes.push_back(grown(tier, -lane * lane_gap * spacing));
  for (std::uint32_t lane = 0; lane < 2; ++lane) {
    const double length = layout.lanes[lane].length();
    const auto room = static_cast<std::size_t>(length / (athlete_pitch * spacing));
    const std::size_t count = std::min(lane == 0 ? (wanted + 1) / 2 : wanted - layout.walkers.size(), room);
    const double step = length / static_cast<double>(std::max<std::size_t>(count, 1));
    for (std::size_t athlete = 0; athlete < count; ++athlete) {
      const double jitter = static_cast<double>(random.between(-0.3F, 0.3F)) * step;
      layout.walkers.push_back({lane, std::fmod(static_cast<double>(athlete) * step + jitter + length, length)});
    }
  }
}

}  // namespace

CrowdLayout stadium_layout(std::size_t agents, std::uint32_t seed, const CharacterRoles& roles) {
  const double spacing = roles.spacing();
  const Lane tier = lowest_tier(agents, roles);
  CrowdLayout layout;
  layout.walkers_habit = Habit::train;
  const std::size_t athletes = athletes_of(agents, roles);
  if (athletes > 0) add_athletes(athletes, tier, spacing, Random(seed, 6), layout);
  for (const StadiumTier& each : tiers_for(agents - layout.walkers.size(), tier, spacing)) seat_tier(each, layout);
  layout.wave_seconds = std::max(least_wave_seconds, tier.length() / (wave_speed * spacing));
  return layout;
}

std::vector<StadiumTier> stadium_tiers(std::size_t agents, const CharacterRoles& roles) {
  const Lane lowest = lowest_tier(agents, roles);
  CrowdLayout athletes;
  const std::size_t wanted = athletes_of(agents, roles);
  if (wanted > 0) add_athletes(wanted, lowest, roles.spacing(), Random(0, 6), athletes);
  return tiers_for(agents - athletes.walkers.size(), lowest, roles.spacing());
}

LanePoint stadium_seat(const StadiumTier& tier, std::size_t seat) {
  const Lane& lane = tier.lane;
  const double corner = std::numbers::pi / 2.0 * lane.corner_radius;
  const double far_side = 0.5 * lane.length() + 2.0 * lane.core.y + corner + lane.core.x;  // the side at -Z: its middle
  const LanePoint place =
      lane.at(far_side + static_cast<double>(seat) / static_cast<double>(tier.seats) * lane.length());
  // The way round, turned a quarter towards the field.
  return {place.position, {place.heading.sine, -place.heading.cosine}};
}

StadiumSize stadium_size(std::size_t agents, const CharacterRoles& roles) {
  const Lane tier = lowest_tier(agents, roles);
  const auto tiers = static_cast<double>(tier_count(agents));
  return {tier.core.x + tier.corner_radius, tier.core.y + tier.corner_radius, tiers * tier_pitch * roles.spacing(),
          tiers * tier_rise * roles.spacing()};
}

Wave::Wave(const CrowdLayout& layout, CrowdMinds& minds)
    : first_stander_(layout.walkers.size() + layout.marchers.size()), period_(to_ticks(layout.wave_seconds)) {
  const Ticks first_wave = to_ticks(layout.wave_begins);
  for (std::size_t stander = 0; stander < layout.standers.size(); ++stander) {
    const auto unevenness = static_cast<double>(minds.whim(first_stander_ + stander).between(-1.0F, 1.0F));
    const double after = layout.standers[stander].round * layout.wave_seconds + wave_unevenness * unevenness;
    next_.push_back(first_wave + to_ticks(after));
  }
}

// Seen from afar, the wave runs round.
void Wave::advance(Ticks now, const CrowdCast& cast, CrowdMinds& minds) {
  for (std::size_t stander = 0; stander < next_.size(); ++stander) {
    if (now < next_[stander]) continue;
    const Ticks late = (now - next_[stander]) % period_;
    next_[stander] = now - late + period_;
    const std::size_t agent = first_stander_ + stander;
    if (minds.habits()[agent] == Habit::act) continue;
    const Role up = cast.of(agent).playable(Role::cheer) ? Role::cheer : Role::stand;
    if (late < up_in_wave) minds.interrupt(agent, up, now - late + up_in_wave);
  }
}

}  // namespace throng::app
