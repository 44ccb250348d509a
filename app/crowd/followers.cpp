#include "app/crowd/followers.h"

#include <algorithm>
#include <cassert>
#include <numbers>
#include <utility>

#include "app/crowd/numbers/random.h"

namespace throng::app {
namespace {

constexpr std::uint64_t headings_stream = 17;

}  // namespace

Followers::Followers(TrackSource source, std::span<const std::uint8_t> characters, std::span<const float> scales,
                     std::uint32_t seed)
    : source_(std::move(source)),
      characters_(characters.begin(), characters.end()),
      scales_(scales.begin(), scales.end()),
      bounds_(bounds_of(*source_.trajectories)) {
  const Trajectories& all = *source_.trajectories;
  assert(all.persons.size() == characters.size() && characters.size() == scales.size());
  const double row = row_seconds(all);
  Random random(seed, headings_stream);
  constexpr float half_turn = std::numbers::pi_v<float>;
  for (std::size_t agent = 0; agent < characters.size(); ++agent) {
    const PersonTrack& person = all.persons[agent];
    first_headings_.push_back(random.between(-half_turn, half_turn));
    presences_.push_back(presence_of(person, row));
    tracks_.push_back(person.rows.empty() ? SmoothTrack() : SmoothTrack(person.rows));
    steps_.emplace_back(tracks_.back(), plane(agent), scales[agent], first_headings_.back());
  }
  talks_ = Talks(tracks_, steps_);
}

void Followers::begin_renewing(std::span<const std::uint32_t> agents) {
  talks_ = {};
  for (const std::uint32_t agent : agents) add_to(bounds_, source_.trajectories->persons[agent].rows.back());
}

float Followers::renew(std::size_t agent, float height, double settled) {
  const PersonTrack& person = source_.trajectories->persons[agent];
  const float scale = person.stature > 0.0F ? person.stature / height : scales_[agent];
  Presence& known = presences_[agent];
  Presence now = presence_of(person, row_seconds(*source_.trajectories));
  if (now.first <= known.last) now.first = std::min(now.first, known.first);  // older rows may be gone
  known = now;
  tracks_[agent] = SmoothTrack(person.rows);
  steps_[agent].extend(tracks_[agent], plane(agent), scale, first_headings_[agent], settled);
  return scale;
}

}  // namespace throng::app
