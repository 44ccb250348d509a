#include "app/show/stage/event_sums.h"

#include <bit>

#include "engine/base/hash.h"

namespace throng::app {
namespace {

// A clip that has faded out may stay in an agent's graph until it is posed again.
constexpr float least_weight = 1e-3F;

std::uint64_t bits_of(float a, float b) {
  return std::uint64_t{std::bit_cast<std::uint32_t>(a)} << 32U | std::bit_cast<std::uint32_t>(b);
}

}  // namespace

void EventSums::reset(std::size_t agents) {
  events_ = place_hash_ = 0;
  hashes_.assign(agents, 0);
}

void EventSums::add_events(const anim::AnimationSystem& system, Ticks before) {
  for (std::uint32_t agent = 0; agent < hashes_.size(); ++agent) {
    system.agent(agent).motion().for_each_data_key(before, system.clock(), [&](const anim::DataKeyEvent& event) {
      if (event.weight <= least_weight) return;
      ++events_;
      const std::uint64_t what = std::uint64_t{event.name} << 32U | event.clip;
      hashes_[agent] = chain_hash(chain_hash(hashes_[agent], what), static_cast<std::uint64_t>(event.time.count()));
    });
  }
}

void EventSums::add_places(const Crowd& crowd) {
  for (std::size_t agent = 0; agent < crowd.size(); ++agent) {
    const glm::vec3& at = crowd.positions()[agent];
    const Heading& heading = crowd.headings()[agent];
    place_hash_ = chain_hash(place_hash_, bits_of(at.x, at.z) ^ mix_bits(bits_of(at.y, 0.0F)));
    place_hash_ = chain_hash(place_hash_, bits_of(heading.cosine, heading.sine));
  }
}

std::uint64_t EventSums::event_hash() const {
  std::uint64_t hash = 0;
  for (const std::uint64_t of_agent : hashes_) hash = chain_hash(hash, of_agent);
  return hash;
}

}  // namespace throng::app
