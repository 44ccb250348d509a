#include "engine/tracks/smooth_track.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace throng {
namespace {

constexpr float most_over_slower = 2.0F;  // of the secant on the slower side of a row

glm::vec2 place_of(const TrackRow& row) { return {row.x, row.z}; }

float seconds_between(const TrackRow& a, const TrackRow& b) { return static_cast<float>(b.seconds - a.seconds); }

bool is_jump(const TrackRow& a, const TrackRow& b) {
  return glm::distance(place_of(a), place_of(b)) > fastest_person * seconds_between(a, b);
}

/// Keeps a velocity from being much faster than the slower of `in` and `out`.
glm::vec2 at_most(const glm::vec2& velocity, const glm::vec2& in, const glm::vec2& out) {
  const float most = most_over_slower * std::min(glm::length(in), glm::length(out)), length = glm::length(velocity);
  return length > most ? velocity * (most / length) : velocity;
}

}  // namespace

float wrapped_angle(float angle) {
  constexpr float turn = 2.0F * std::numbers::pi_v<float>;
  return angle - turn * std::round(angle / turn);
}

// Rows mostly come evenly, so the place of a time is guessed first.
std::size_t SmoothTrack::row_before(double seconds) const {
  const std::size_t most = rows_.size() - 1;
  const double share = (seconds - first()) / std::max(last() - first(), 1e-9);
  std::size_t row = std::min(static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * static_cast<double>(most)), most);
  constexpr int near = 4;
  for (int step = 0; step < near && row > 0 && rows_[row].seconds > seconds; ++step) --row;
  for (int step = 0; step < near && row < most && rows_[row + 1].seconds <= seconds; ++step) ++row;
  const bool found = rows_[row].seconds <= seconds && (row == most || rows_[row + 1].seconds > seconds);
  if (found || seconds < first()) return row;
  const auto after = std::ranges::upper_bound(rows_, seconds, {}, &TrackRow::seconds);
  return static_cast<std::size_t>(after - rows_.begin()) - 1;
}

glm::vec2 SmoothTrack::slope(std::size_t row) const {
  const auto secant = [&](std::size_t from) {
    const glm::vec2 way = place_of(rows_[from + 1]) - place_of(rows_[from]);
    return way / seconds_between(rows_[from], rows_[from + 1]);
  };
  const std::size_t end = rows_.size() - 1;
  if (row == 0 || row == end) {
    const std::size_t only = row == 0 ? 0 : end - 1, inner = row == 0 ? 1 : end - 1;
    if (is_jump(rows_[only], rows_[only + 1])) return glm::vec2(0.0F);
    return end == 1 ? secant(only) : at_most(1.5F * secant(only) - 0.5F * slope(inner), secant(only), secant(only));
  }
  const bool jumped = is_jump(rows_[row - 1], rows_[row]), jumps = is_jump(rows_[row], rows_[row + 1]);
  if (jumped || jumps) return jumped && jumps ? glm::vec2(0.0F) : secant(jumped ? row : row - 1);
  const float before = seconds_between(rows_[row - 1], rows_[row]), after = seconds_between(rows_[row], rows_[row + 1]);
  const glm::vec2 in = secant(row - 1), out = secant(row);
  return at_most((in * after + out * before) / (before + after), in, out);
}

glm::vec3 SmoothTrack::position(double seconds) const {
  const std::size_t row = row_before(seconds);
  const TrackRow& from = rows_[row];
  if (seconds <= from.seconds || row + 1 == rows_.size()) return {from.x, from.y, from.z};
  const TrackRow& to = rows_[row + 1];
  const float length = seconds_between(from, to);
  const float t = static_cast<float>(seconds - from.seconds) / length;
  if (is_jump(from, to)) return t < 0.5F ? glm::vec3(from.x, from.y, from.z) : glm::vec3(to.x, to.y, to.z);
  const float back = 1.0F - t, to_weight = t * t * (3.0F - 2.0F * t);
  const glm::vec2 place =
      glm::mix(place_of(from), place_of(to), to_weight) + length * t * back * (slope(row) * back - slope(row + 1) * t);
  return {place.x, glm::mix(from.y, to.y, t), place.y};
}

glm::vec2 SmoothTrack::velocity(double seconds, double window) const {
  const double begin = std::clamp(seconds - 0.5 * window, first(), last());
  const double end = std::clamp(seconds + 0.5 * window, first(), last());
  constexpr double shortest = 1e-3;
  if (end - begin < shortest) return glm::vec2(0.0F);
  const glm::vec3 way = position(end) - position(begin);
  const glm::vec2 mean = glm::vec2(way.x, way.z) / static_cast<float>(end - begin);
  return glm::length(mean) > fastest_person ? glm::vec2(0.0F) : mean;
}

float SmoothTrack::heading(double seconds) const {
  const std::size_t row = row_before(seconds);
  const TrackRow& from = rows_[row];
  if (seconds <= from.seconds || row + 1 == rows_.size()) return from.heading;
  const TrackRow& to = rows_[row + 1];
  const float t = static_cast<float>(seconds - from.seconds) / seconds_between(from, to);
  return from.heading + t * wrapped_angle(to.heading - from.heading);
}

}  // namespace throng
