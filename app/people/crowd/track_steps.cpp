#include "app/people/crowd/track_steps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace throng::app {
namespace {

constexpr double knot_seconds = 0.1, far_knot_seconds = 0.2;
constexpr double most_knots_a_row = 300.0;                   // in the mean, so that rows years apart take no memory
constexpr double stand_window = 3.0;                         // seconds in which a person who stands gets nowhere
constexpr float stands_below = 0.015F, moves_above = 0.06F;  // metres a second over that window
constexpr float turns_above = 0.08F;                         // metres a second
constexpr float turns_at_once = 0.9F;                        // metres a second
constexpr float turned_a_second = 10.0F;                     // of the rest of a turn, at that speed
constexpr float turns_with_file = 25.0F;                     // of the rest of a turn, towards a heading of the file

float direction_of(const glm::vec2& way) { return std::atan2(way.x, way.y); }

/// Returns the share of the rest of a turn that a person of this speed makes in some seconds.
float share_of_turn(float speed, double seconds) {
  const float eager = glm::clamp((speed - turns_above) / (turns_at_once - turns_above), 0.0F, 1.0F);
  return 1.0F - std::exp(-turned_a_second * eager * std::sqrt(eager) * static_cast<float>(seconds));
}

// A person who stands sways too, but makes no steps by swaying.
glm::vec2 velocity_of_steps(const SmoothTrack& track, double seconds) {
  const glm::vec2 velocity = track.velocity(seconds, TrackSteps::stride_window);
  const float got_on = glm::length(track.velocity(seconds, stand_window));
  return velocity * glm::smoothstep(stands_below, moves_above, got_on);
}

glm::vec2 seen_by(float heading, const glm::vec2& velocity) {
  const float sine = std::sin(heading), cosine = std::cos(heading);
  return {velocity.x * cosine - velocity.y * sine, velocity.x * sine + velocity.y * cosine};
}

}  // namespace

TrackSteps::TrackSteps(const SmoothTrack& track, const StridePlane& plane, float scale, float first_heading) {
  if (track.row_count() > 0) extend(track, plane, scale, first_heading, track.first());
}

void TrackSteps::begin(const SmoothTrack& track) {
  const double between_rows =
      (track.last() - track.first()) / std::max<double>(static_cast<double>(track.row_count()) - 1.0, 1.0);
  first_ = track.first();
  spacing_ =
      std::max(between_rows < far_knot_seconds ? knot_seconds : far_knot_seconds, between_rows / most_knots_a_row);
  knots_.clear();
}

void TrackSteps::end_with(const SmoothTrack& track) {
  knots_.resize(static_cast<std::size_t>(std::ceil((track.last() - first_) / spacing_)) + 1);
}

void TrackSteps::extend(const SmoothTrack& track, const StridePlane& plane, float scale, float first_heading,
                        double settled) {
  constexpr std::size_t most_old = 64;  // knots are taken from the front in lots
  const bool goes_on = !knots_.empty() && settled >= first_ && track.first() <= time_of(knots_.size() - 1);
  std::size_t from = 0;
  if (goes_on) {
    from = std::min(static_cast<std::size_t>((settled - first_) / spacing_) + 2, knots_.size());
    const auto old = static_cast<std::size_t>(std::max((track.first() - first_) / spacing_, 0.0));
    if (old > most_old && old < from) {
      knots_.erase(knots_.begin(), knots_.begin() + static_cast<std::ptrdiff_t>(old));
      first_ = time_of(old), from -= old;
    }
  } else {
    begin(track);
  }
  end_with(track);
  turn(track, first_heading, from);
  walk(track, plane, scale, from);
}

float TrackSteps::heading_at_first(const SmoothTrack& track, float first_heading) const {
  if (track.has_heading()) return track.heading(first_);
  for (std::size_t i = 0; i < knots_.size(); ++i) {
    const glm::vec2 velocity = track.velocity(time_of(i), stride_window);
    if (glm::length(velocity) > 0.5F * turns_at_once) return direction_of(velocity);
  }
  const glm::vec3 way = track.position(track.last()) - track.position(first_);
  constexpr float got_somewhere = 0.2F;  // metres
  return std::hypot(way.x, way.z) > got_somewhere ? direction_of({way.x, way.z}) : first_heading;
}

void TrackSteps::turn(const SmoothTrack& track, float first_heading, std::size_t from) {
  const bool is_told = track.has_heading();
  float heading = from > 0 ? knots_[from - 1].heading : heading_at_first(track, first_heading);
  for (std::size_t i = from; i < knots_.size(); ++i) {
    const glm::vec2 velocity = track.velocity(time_of(i), stride_window);
    const float wanted = is_told ? track.heading(time_of(i)) : direction_of(velocity);
    const float share = is_told ? 1.0F - std::exp(-turns_with_file * static_cast<float>(spacing_))
                                : share_of_turn(glm::length(velocity), spacing_);
    heading += share * wrapped_angle(wanted - heading);
    knots_[i].heading = heading;
  }
}

void TrackSteps::walk(const SmoothTrack& track, const StridePlane& plane, float scale, std::size_t from) {
  double cycles = 0.0, pace_before = 0.0;
  if (from > 0) {
    cycles = static_cast<double>(knots_[from - 1].cycles);
    pace_before = plane.stride(knots_[from - 1].velocity).cycles_per_second;
  }
  for (std::size_t i = from; i < knots_.size(); ++i) {
    Knot& knot = knots_[i];
    knot.velocity = seen_by(knot.heading, velocity_of_steps(track, time_of(i))) / scale;
    const double pace = plane.stride(knot.velocity).cycles_per_second;
    if (i > 0) cycles += 0.5 * (pace_before + pace) * spacing_;
    pace_before = pace;
    knot.cycles = static_cast<float>(std::fmod(cycles, static_cast<double>(cycles_in_all)));
  }
}

TrackStep TrackSteps::at(double seconds) const {
  if (knots_.empty()) return {};
  const double place = std::clamp((seconds - first_) / spacing_, 0.0, static_cast<double>(knots_.size() - 1));
  const auto knot = std::min(static_cast<std::size_t>(place), std::max<std::size_t>(knots_.size(), 2) - 2);
  const auto t = static_cast<float>(place - static_cast<double>(knot));
  const Knot& from = knots_[knot];
  const Knot& to = knots_[std::min(knot + 1, knots_.size() - 1)];
  float way = to.cycles - from.cycles;
  if (way < 0.0F) way += cycles_in_all;
  return {.heading = from.heading + t * (to.heading - from.heading),
          .velocity = glm::mix(from.velocity, to.velocity, t),
          .cycles = static_cast<double>(from.cycles) + static_cast<double>(t * way)};
}

}  // namespace throng::app
