#include "app/window/tracked_person_reporter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/people/measure/crowd_measures.h"
#include "app/show/stage/stage.h"

namespace throng::app {
namespace {

constexpr double between_speeds = 0.1;  // seconds
constexpr std::size_t most_speeds = 2048;
constexpr double longest_ways = 0.1, most_ways = 300'000.0;  // seconds between two sums; sums in all
constexpr double between_looks = 0.02;                       // seconds, of which a foot is longer in the air
constexpr int looks_a_frame = 4000;
constexpr float is_down = 0.5F;

// Both go by the mean velocity of a stride, as a head that sways goes farther than the person does.
void add_speeds(const Followers& followers, std::uint32_t agent, TrackedPerson& person) {
  const double length = person.presence.last - person.presence.first;
  const auto count = std::clamp(static_cast<std::size_t>(length / between_speeds) + 1, std::size_t{2}, most_speeds);
  const double spacing = length / static_cast<double>(count - 1);
  const double sums =
      std::clamp(std::ceil(spacing / longest_ways), 1.0, std::ceil(most_ways / static_cast<double>(count)));
  double walked = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double seconds = person.presence.first + spacing * static_cast<double>(i);
    person.speeds.push_back(speed_of(followers, agent, seconds, spacing));
    person.ways.push_back(static_cast<float>(walked));
    for (double sum = 0.5; sum < sums; ++sum) {
      walked += static_cast<double>(speed_of(followers, agent, seconds + sum / sums * spacing)) * spacing / sums;
    }
  }
}

}  // namespace

std::shared_ptr<const TrackedPerson> TrackedPersonReporter::report(const Stage& stage) {
  const bool is_recorded = stage.crowd().tracks() != nullptr && !stage.trajectories()->is_live;
  if (!stage.selected() || !is_recorded) return person_ = nullptr;
  const bool is_same = person_ != nullptr && agent_ == stage.selected() && crowd_ == stage.animated().number();
  if (!is_same) begin(stage, *stage.selected());
  if (!person_->has_all_footfalls) find_footfalls(stage);
  return person_;
}

void TrackedPersonReporter::begin(const Stage& stage, std::uint32_t agent) {
  const Followers& followers = stage.crowd().tracks()->people();
  const PersonTrack& track = followers.trajectories().persons[agent];
  person_ = std::make_shared<TrackedPerson>();
  person_->id = track.id;
  person_->presence = followers.presence(agent);
  person_->rows = track.rows.size();
  person_->stature =
      stage.crowd().scales()[agent] * static_cast<float>(stage.character_of(agent).character->bounds.height);
  person_->origin = followers.trajectories().origin;
  add_speeds(followers, agent, *person_);
  agent_ = agent;
  crowd_ = stage.animated().number();
  searched_ = person_->presence.first;
}

void TrackedPersonReporter::find_footfalls(const Stage& stage) {
  const TrackPlayers& players = *stage.animated().details().track_players();
  std::array<float, person_legs> before = players.planted_at(agent_, searched_);
  for (int look = 0; look < looks_a_frame && searched_ < person_->presence.last; ++look) {
    const double next = std::min(searched_ + between_looks, person_->presence.last);
    const std::array<float, person_legs> planted = players.planted_at(agent_, next);
    const std::ptrdiff_t known = std::ssize(person_->footfalls);
    for (std::size_t leg = 0; leg < person_legs; ++leg) {
      if (before.at(leg) >= is_down || planted.at(leg) < is_down) continue;
      const auto share = static_cast<double>((is_down - before.at(leg)) / (planted.at(leg) - before.at(leg)));
      person_->footfalls.push_back({.seconds = std::lerp(searched_, next, share), .is_left = leg == 0});
    }
    std::ranges::sort(person_->footfalls.begin() + known, person_->footfalls.end(), {}, &Footfall::seconds);
    before = planted;
    searched_ = next;
  }
  person_->has_all_footfalls = searched_ >= person_->presence.last;
}

}  // namespace throng::app
