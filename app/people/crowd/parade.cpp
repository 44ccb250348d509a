#include "app/people/crowd/parade.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "engine/base/random.h"

namespace throng::app {
namespace {

// Metres, for a person 1.8 m tall.
constexpr double least_file_pitch = 0.85;
constexpr double rank_pitch = 1.3;
constexpr double inside_of_route = 5.0;  // least radius of the innermost file
constexpr double clear_of_route = 1.5;
constexpr double spectator_pitch = 0.8;
constexpr double spectator_row = 0.95;

constexpr double share_of_marchers = 0.6;
constexpr std::size_t ranks_in_company = 8;
constexpr double road_a_marching_metre = 1.6;  // of route, so that companies have road between them
constexpr int slowness_to_catch_up = 4;        // a marcher that is behind makes up one second in so many
constexpr double quarter_turn = std::numbers::pi / 2.0;

struct Formation {
  std::size_t marchers = 0, files = 1, ranks = 0;
  double file_pitch = 1.0;

  double half_width() const { return 0.5 * static_cast<double>(files - 1) * file_pitch; }
};

Formation formation_of(std::size_t agents, const CharacterRoles& roles) {
  Formation formation;
  if (!roles.can_walk()) return formation;
  formation.marchers = static_cast<std::size_t>(std::ceil(share_of_marchers * static_cast<double>(agents)));
  const auto wide = std::lround(std::sqrt(static_cast<double>(formation.marchers) / 8.0));
  formation.files = static_cast<std::size_t>(std::max(wide, 1L));
  formation.ranks = (formation.marchers + formation.files - 1) / formation.files;
  const double cycle_on_turn = roles.walk_speed * roles.walk_seconds / quarter_turn;
  const double least = least_file_pitch * roles.spacing();
  formation.file_pitch = cycle_on_turn * std::max(1.0, std::ceil(least / cycle_on_turn));
  return formation;
}

Lane route_of(const Formation& formation, const CharacterRoles& roles) {
  const double spacing = roles.spacing();
  const double radius = formation.half_width() + inside_of_route * spacing;
  const double wanted = road_a_marching_metre * rank_pitch * spacing * static_cast<double>(formation.ranks);
  const double straight = std::max(wanted - 2.0 * std::numbers::pi * radius, 8.0 * radius) / 4.0;
  return {{0.0, 0.0}, {straight, 0.0}, radius, 1.0, roles.walk_speed};
}

void line_up(const Formation& formation, const Lane& route, double spacing, CrowdLayout& layout) {
  const double companies = std::ceil(static_cast<double>(formation.ranks) / ranks_in_company);
  const double in_ranks = static_cast<double>(formation.ranks) * rank_pitch * spacing;
  const double gap = (route.length() - in_ranks) / companies;
  // On the straight at -Z, where the sun of noon and afternoon shines into faces.
  const double head = quarter_turn * route.corner_radius + 1.5 * route.core.x + 0.5 * route.length();
  for (std::size_t marcher = 0; marcher < formation.marchers; ++marcher) {
    const std::size_t rank = marcher / formation.files, file = marcher % formation.files;
    const std::size_t company = rank / ranks_in_company;
    const double behind = static_cast<double>(rank) * rank_pitch * spacing + static_cast<double>(company) * gap;
    const double from_middle = static_cast<double>(file) - 0.5 * static_cast<double>(formation.files - 1);
    layout.marchers.push_back({std::fmod(head - behind + route.length(), route.length()),
                               from_middle * formation.file_pitch, static_cast<std::uint32_t>(company)});
  }
}

/// Rows of spectators on one side of the route.
struct Stand {
  Lane row;
  double facing;  // 1: towards the loop's middle, -1: away from it
};

Stand stand_beside(const Lane& route, double half_width, std::size_t row, double spacing) {
  const bool outside = row % 2 == 0;
  const std::size_t rows_before = row / 2;
  const double away = half_width + (clear_of_route + spectator_row * static_cast<double>(rows_before)) * spacing;
  Lane lane = route;
  lane.corner_radius = outside ? route.corner_radius + away : route.corner_radius - away;
  return {lane, outside ? 1.0 : -1.0};
}

// Some spectators stand close together, some leave a gap; a row begins only where the row before it is full.
void add_row(const Stand& stand, std::size_t count, double spacing, Random& random, CrowdLayout& layout) {
  const double step = stand.row.length() / static_cast<double>(count);
  const double loose = std::min(step - 0.7 * spacing, 3.0 * spacing);
  for (std::size_t spectator = 0; spectator < count; ++spectator) {
    const double jitter = std::max(0.0, loose) * static_cast<double>(random.between(-0.5F, 0.5F));
    const LanePoint place = stand.row.at(static_cast<double>(spectator) * step + jitter);
    const auto facing = static_cast<float>(stand.facing);
    // The way walked, turned a quarter towards the loop's middle.
    const Heading inward{facing * place.heading.sine, -facing * place.heading.cosine};
    layout.standers.push_back({.position = place.position, .heading = inward, .habit = Habit::watch});
  }
}

/// Some of the spectators, in one row.
struct SpectatorRow {
  Stand stand;
  std::size_t count;
};

std::vector<SpectatorRow> spectator_rows(std::size_t wanted, const Lane& route, double half_width, double spacing) {
  std::vector<SpectatorRow> rows;
  for (std::size_t row = 0; wanted > 0; ++row) {
    const Stand stand = stand_beside(route, half_width, row, spacing);
    if (stand.row.corner_radius < spacing) continue;
    const auto room = static_cast<std::size_t>(stand.row.length() / (spectator_pitch * spacing));
    const std::size_t count = std::min(row == 0 ? (wanted + 1) / 2 : wanted, room);
    rows.push_back({stand, count});
    wanted -= count;
  }
  return rows;
}

}  // namespace

CrowdLayout parade_layout(std::size_t agents, std::uint32_t seed, const CharacterRoles& roles) {
  const Formation formation = formation_of(agents, roles);
  CrowdLayout layout;
  layout.route = route_of(formation, roles);
  if (formation.marchers > 0) line_up(formation, layout.route, roles.spacing(), layout);
  Random random(seed, 5);
  const std::size_t spectators = agents - formation.marchers;
  for (const auto& [stand, count] : spectator_rows(spectators, layout.route, formation.half_width(), roles.spacing())) {
    add_row(stand, count, roles.spacing(), random, layout);
  }
  return layout;
}

LanePoint marcher_place(const Lane& route, const MarcherStart& marcher, double seconds) {
  LanePoint place = route.at(marcher.distance + route.speed * seconds);
  const glm::dvec2 forward(static_cast<double>(place.heading.sine), static_cast<double>(place.heading.cosine));
  place.position += marcher.offset * route.direction * glm::dvec2(forward.y, -forward.x);
  return place;
}

void Marchers::begin(CrowdPlaces& places) const {
  for (std::size_t agent = first_; const MarcherStart& start : starts_) {
    const LanePoint place = marcher_place(route_, start, 0.0);
    places.positions[agent] = {place.position.x, 0.0, place.position.y};
    places.headings[agent] = place.heading;
    places.speeds[agent++] = static_cast<float>(route_.speed);
  }
}

double Marchers::marching_time(std::size_t marcher, Ticks dt, Ticks now, bool is_held) {
  Ticks& behind = behind_[marcher];
  if (is_held) {
    behind += dt;
  } else {
    behind = std::max(Ticks{}, behind - dt / slowness_to_catch_up);
  }
  return to_seconds(now - behind);
}

void Marchers::advance(Ticks dt, Ticks now, const CrowdMinds& minds, CrowdPlaces& places) {
  for (std::size_t marcher = 0; marcher < count(); ++marcher) {
    const std::size_t agent = first_ + marcher;
    const double time = marching_time(marcher, dt, now, minds.holds(agent));
    const LanePoint place = marcher_place(route_, starts_[marcher], time);
    const glm::vec3 position(place.position.x, 0.0, place.position.y);
    places.speeds[agent] =
        static_cast<float>(static_cast<double>(glm::distance(position, places.positions[agent])) / to_seconds(dt));
    places.positions[agent] = position;
    places.headings[agent] = place.heading;
  }
}

// Each marcher stays where it is. Its start moves instead, since a place follows from start, speed and time.
void Marchers::take_speed(double speed, Ticks now) {
  for (std::size_t marcher = 0; marcher < count(); ++marcher) {
    starts_[marcher].distance += (route_.speed - speed) * to_seconds(now - behind_[marcher]);
  }
  route_.speed = speed;
}

double marcher_phase(const Lane& route, const MarcherStart& marcher, const CharacterRoles& roles) {
  // Two straights and four quarter turns; on a turn the file has fallen behind or gone ahead by its offset times the
  // angle.
  const double corner = quarter_turn * route.corner_radius, half = 2.0 * (corner + route.core.x);
  const double on_half = std::fmod(marcher.distance, half);
  const double quarters = std::min(on_half, corner) / corner + std::max(0.0, on_half - half + corner) / corner +
                          2.0 * std::floor(marcher.distance / half);
  const double cycles = marcher.offset * quarters * quarter_turn / (roles.walk_speed * roles.walk_seconds);
  return cycles - std::floor(cycles);
}

ParadeSize parade_size(std::size_t agents, const CharacterRoles& roles) {
  const Formation formation = formation_of(agents, roles);
  const Lane route = route_of(formation, roles);
  const double first_row = formation.half_width() + clear_of_route * roles.spacing();
  ParadeSize size{route.core.x, route.corner_radius, formation.half_width(), first_row, formation.half_width()};
  for (const SpectatorRow& row :
       spectator_rows(agents - formation.marchers, route, formation.half_width(), roles.spacing())) {
    const double away = row.stand.row.corner_radius - route.corner_radius;
    size.outside = std::max(size.outside, away);
    size.inside = std::max(size.inside, -away);
  }
  return size;
}

}  // namespace throng::app
