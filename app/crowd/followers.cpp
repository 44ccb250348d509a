#include "app/crowd/followers.h"

#include <cassert>
#include <numbers>
#include <utility>

#include "app/crowd/random.h"

namespace throng::app {
namespace {

constexpr std::uint64_t headings_stream = 17;

}  // namespace

Followers::Followers(TrackSource source, std::span<const std::uint8_t> characters, std::span<const float> scales,
                     std::uint32_t seed)
    : source_(std::move(source)),
      characters_(characters.begin(), characters.end()),
      bounds_(bounds_of(*source_.trajectories)) {
  const Trajectories& all = *source_.trajectories;
  assert(all.persons.size() == characters.size() && characters.size() == scales.size());
  const double row = row_seconds(all);
  Random random(seed, headings_stream);
  constexpr float half_turn = std::numbers::pi_v<float>;
  for (std::size_t agent = 0; agent < characters.size(); ++agent) {
    presences_.push_back(presence_of(all.persons[agent], row));
    tracks_.emplace_back(all.persons[agent].rows);
    steps_.emplace_back(tracks_.back(), plane(agent), scales[agent], random.between(-half_turn, half_turn));
  }
}

}  // namespace throng::app
