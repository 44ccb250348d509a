#include "engine/crowd/watched_agents.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace throng {

void WatchedAgents::reset(std::size_t agents, std::size_t watched, std::size_t entries) {
  constexpr std::size_t poses = 2;  // from and to
  const std::size_t stride = anim::palette_stride(entries, PaletteFormat::matrices);
  if (watched != watched_.size() || palettes_ == nullptr) {
    palettes_ = anim::allocate_aligned(watched * poses * stride);
  }
  watched_.assign(watched, {});
  free_.clear();
  free_.reserve(watched);
  lots_.clear();
  lots_.reserve(watched);
  place_of_.assign(agents, WatchedAgent::no_agent);
  std::byte* next = palettes_.get();
  for (WatchedAgent& each : watched_) {
    for (std::byte** const palette : {&each.from, &each.to}) {
      *palette = std::exchange(next, next + stride);
    }
    free_.push_back(static_cast<std::uint32_t>(watched - 1 - free_.size()));
  }
}

void WatchedAgents::stop(WatchedAgent& watched) {
  place_of_[watched.agent] = WatchedAgent::no_agent;
  free_.push_back(static_cast<std::uint32_t>(&watched - watched_.data()));
  watched.agent = WatchedAgent::no_agent;
}

void WatchedAgents::watch(std::uint32_t agent) {
  if (free_.empty() || place_of_[agent] != WatchedAgent::no_agent) return;
  const std::uint32_t place = free_.back();
  free_.pop_back();
  place_of_[agent] = place;
  WatchedAgent& watched = watched_[place];
  watched.agent = agent;
  watched.frames_left = few_frames;
  watched.from_known = watched.to_known = false;
  watched.measured_in = watched.measured_again_in = WatchedAgent::never;
}

void WatchedAgents::choose(std::span<const anim::VisibleAgent> visible, const ShownPoses& shown) {
  const bool watches_all = watched_.size() == place_of_.size();
  for (WatchedAgent& watched : watched_) {
    if (watched.agent == WatchedAgent::no_agent) continue;
    const bool over = !watches_all && watched.frames_left-- == 0;
    if (over || !shown.pose(watched.agent).shown()) stop(watched);
  }
  if (!watches_all) return fill_by_height(visible);
  for (const anim::VisibleAgent& agent : visible) watch(agent.agent);
}

// Draws a lot for each free place first, then goes through the crowd once.
void WatchedAgents::fill_by_height(std::span<const anim::VisibleAgent> visible) {
  constexpr std::size_t worth_a_pass = 8;
  if (free_.size() < worth_a_pass) return;
  float total = 0.0F;
  for (const anim::VisibleAgent& agent : visible) total += agent.pixels_tall;
  lots_.clear();
  for (std::size_t i = 0; i < free_.size(); ++i) lots_.push_back(random_.unit() * total);
  std::ranges::sort(lots_);
  auto lot = lots_.begin();
  float passed = 0.0F;
  for (const anim::VisibleAgent& agent : visible) {
    passed += agent.pixels_tall;
    if (lot == lots_.end()) return;
    if (*lot >= passed) continue;
    watch(agent.agent);
    while (lot != lots_.end() && *lot < passed) ++lot;
  }
}

std::byte* WatchedAgents::destination(std::uint32_t agent, const ShownPose& pose, std::uint32_t entries,
                                      std::byte* slot_memory) {
  const std::uint32_t place = place_of_[agent];
  if (place == WatchedAgent::no_agent || slot_memory == nullptr) return slot_memory;
  WatchedAgent& watched = watched_[place];
  watched.blends = pose.from.first_line != pose.to.first_line;
  watched.from_known = watched.to_known && pose.from_format == pose.to_format &&
                       watched.to_slot.page == pose.from.page && watched.to_slot.first_line == pose.from.first_line;
  std::swap(watched.from, watched.to);
  watched.to_known = true;
  watched.to_slot = pose.to;
  watched.format = pose.to_format;
  watched.slot_memory = slot_memory;
  watched.entries = entries;
  return watched.to;
}

void WatchedAgents::hand_over() {
  for (WatchedAgent& watched : watched_) {
    std::byte* const slot = std::exchange(watched.slot_memory, nullptr);
    if (slot != nullptr) std::memcpy(slot, watched.to, watched.entries * anim::palette_entry_bytes(watched.format));
  }
}

}  // namespace throng
