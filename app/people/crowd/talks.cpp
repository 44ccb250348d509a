#include "app/people/crowd/talks.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "engine/base/random.h"

namespace throng::app {
namespace {

constexpr double sample_seconds = 0.5;                      // from one look at all people to the next
constexpr double window_seconds = 3.0;                      // in which a person who stands gets nowhere
constexpr float stander_below = 0.05F;                      // metres a second over that window
constexpr float nearest_talk = 0.6F, farthest_talk = 1.5F;  // metres between people who talk
constexpr float reach = 1.6F;  // radians from straight ahead that spine and neck turn the eyes by
constexpr double shortest_talk = 2.5, longest_turn = 8.0, between_turns = 2.0;  // seconds
constexpr double turns_head = 0.8;                                              // seconds
constexpr double longest_between_rows = 10.0;  // seconds in the mean; rows farther apart do not say who stands
// Samples of a huge jam beyond these numbers are left out.
constexpr std::size_t most_standers = 8'000'000;  // samples of people
constexpr std::size_t most_meetings = 4'000'000;  // samples of pairs

/// Two people who could talk at a sample.
struct Meeting {
  std::uint32_t one, other;
  std::int64_t sample;

  // The checker takes the nought of a comparison for a null pointer.
  friend auto operator<=>(const Meeting&, const Meeting&) = default;  // NOLINT(modernize-use-nullptr)
};

/// Two people who could talk from a sample to another one.
struct Encounter {
  std::uint32_t one, other;
  std::int64_t first, last;

  double begin() const { return static_cast<double>(first) * sample_seconds; }
  double end() const { return static_cast<double>(last) * sample_seconds; }
};

struct Stander {
  std::int64_t sample;
  std::int32_t column, row;
  std::uint32_t person;
  glm::vec2 place;
  float heading;
};

bool faces(const Stander& one, const Stander& other) {
  const glm::vec2 way = other.place - one.place;
  return std::abs(wrapped_angle(std::atan2(way.x, way.y) - one.heading)) < reach;
}

std::vector<Stander> standers_of(std::span<const SmoothTrack> tracks, std::span<const TrackSteps> steps) {
  std::vector<Stander> standers;
  for (std::uint32_t person = 0; person < tracks.size(); ++person) {
    const SmoothTrack& track = tracks[person];
    if (track.row_count() == 0) continue;
    if (track.last() - track.first() > longest_between_rows * static_cast<double>(track.row_count())) continue;
    const auto last = static_cast<std::int64_t>(std::floor(track.last() / sample_seconds));
    for (auto i = static_cast<std::int64_t>(std::ceil(track.first() / sample_seconds)); i <= last; ++i) {
      const double seconds = static_cast<double>(i) * sample_seconds;
      if (glm::length(track.velocity(seconds, window_seconds)) > stander_below) continue;
      if (standers.size() == most_standers) return standers;
      const glm::vec3 position = track.position(seconds);
      standers.push_back({.sample = i,
                          .column = static_cast<std::int32_t>(std::floor(position.x / farthest_talk)),
                          .row = static_cast<std::int32_t>(std::floor(position.z / farthest_talk)),
                          .person = person,
                          .place = {position.x, position.z},
                          .heading = steps[person].at(seconds).heading});
    }
  }
  return standers;
}

auto cell_of(const Stander& stander) { return std::tuple(stander.sample, stander.column, stander.row); }

/// Finds the pairs of all samples by a grid that is sorted by sample, column and row.
std::vector<Meeting> meetings_of(std::vector<Stander> standers) {
  std::ranges::sort(standers, {},
                    [](const Stander& each) { return std::tuple_cat(cell_of(each), std::tuple(each.person)); });
  std::vector<Meeting> meetings;
  for (const Stander& one : standers) {
    for (std::int32_t column = one.column - 1; column <= one.column + 1; ++column) {
      const std::tuple low(one.sample, column, one.row - 1), high(one.sample, column, one.row + 1);
      const auto first = std::ranges::lower_bound(standers, low, {}, cell_of);
      for (auto other = first; other != standers.end() && cell_of(*other) <= high; ++other) {
        if (other->person <= one.person) continue;
        const float away = glm::distance(one.place, other->place);
        if (away < nearest_talk || away > farthest_talk || !faces(one, *other) || !faces(*other, one)) continue;
        if (meetings.size() == most_meetings) return meetings;
        meetings.push_back({one.person, other->person, one.sample});
      }
    }
  }
  return meetings;
}

/// Returns the encounters that are long enough for a talk, the longest first.
std::vector<Encounter> encounters_of(std::vector<Meeting> meetings) {
  std::ranges::sort(meetings);
  std::vector<Encounter> all;
  for (const Meeting& met : meetings) {
    const bool goes_on =
        !all.empty() && all.back().one == met.one && all.back().other == met.other && met.sample - all.back().last <= 1;
    if (goes_on) {
      all.back().last = met.sample;
    } else {
      all.push_back({met.one, met.other, met.sample, met.sample});
    }
  }
  std::erase_if(all, [](const Encounter& each) { return each.end() - each.begin() < shortest_talk; });
  std::ranges::stable_sort(all, std::ranges::greater{}, [](const Encounter& each) { return each.last - each.first; });
  return all;
}

/// Shares each person's time out among the people who are near enough for a talk.
class TalkPlanner {
 public:
  explicit TalkPlanner(std::size_t people) : glances_(people), taken_(people) {}

  void talk(const Encounter& met) {
    const bool one_is_free = is_free_for(met.one, met), other_is_free = is_free_for(met.other, met);
    if (one_is_free) take(met.one, met, other_is_free);
    if (other_is_free) take(met.other, met, one_is_free);
  }

  std::vector<std::vector<Talks::Glance>> finished() {
    for (auto& each : glances_) std::ranges::sort(each, {}, &Talks::Glance::begin);
    return std::move(glances_);
  }

 private:
  bool is_free_for(std::uint32_t person, const Encounter& met) const {
    return std::ranges::none_of(
        taken_[person], [&](const Encounter& other) { return other.first <= met.last && met.first <= other.last; });
  }

  // The two have equal turns; a person who speaks in one listens in the next.
  void take(std::uint32_t person, const Encounter& met, bool may_speak) {
    taken_[person].push_back(met);
    Random random(met.one, met.other);
    bool speaks = random.chance(0.5F) != (person == met.one);
    double begin = met.begin();
    while (met.end() - begin >= shortest_talk) {
      const auto length = static_cast<double>(random.between(0.5F, 1.0F)) * longest_turn;
      const double end = std::min(begin + std::max(length, shortest_talk), met.end());
      glances_[person].push_back({.begin = begin,
                                  .end = end,
                                  .other = person == met.one ? met.other : met.one,
                                  .speaks = speaks && may_speak});
      begin = end + static_cast<double>(random.unit()) * between_turns;
      speaks = !speaks;
    }
  }

  std::vector<std::vector<Talks::Glance>> glances_;
  std::vector<std::vector<Encounter>> taken_;
};

}  // namespace

Talks::Talks(std::span<const SmoothTrack> tracks, std::span<const TrackSteps> steps) {
  TalkPlanner planner(tracks.size());
  for (const Encounter& met : encounters_of(meetings_of(standers_of(tracks, steps)))) planner.talk(met);
  glances_ = planner.finished();
}

TalkMoment Talks::at(std::size_t person, double seconds) const {
  if (glances_.empty()) return {};
  const std::vector<Glance>& all = glances_[person];
  const auto after = std::ranges::upper_bound(all, seconds, {}, &Glance::begin);
  if (after == all.begin()) return {};
  const Glance& glance = *(after - 1);
  const double inside = std::min(seconds - glance.begin, glance.end - seconds) / turns_head;
  if (inside <= 0.0) return {};
  const auto t = static_cast<float>(std::min(inside, 1.0));
  const float looks = glm::smoothstep(0.0F, 1.0F, t);
  return {.other = glance.other, .looks = looks, .speaks = glance.speaks ? looks : 0.0F};
}

}  // namespace throng::app
