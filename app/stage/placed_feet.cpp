#include "app/stage/placed_feet.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>
#include <utility>

#include <glm/gtc/quaternion.hpp>

namespace throng::app {
namespace {

constexpr anim::Ticks fade = anim::ticks_per_second / 5;
constexpr std::size_t usually_near_by = 256;  // agents of one character

// The model is as large as its agent is tall, so the world is measured in the agent's own size.
anim::JointMotion placement_of(const Crowd& crowd, std::uint32_t agent) {
  const Heading heading = crowd.headings()[agent];
  const float half_cosine = std::sqrt(std::max(0.0F, 0.5F + 0.5F * heading.cosine));
  const float half_sine = std::copysign(std::sqrt(std::max(0.0F, 0.5F - 0.5F * heading.cosine)), heading.sine);
  return {.rotation = {half_cosine, 0.0F, half_sine, 0.0F},
          .position = crowd.positions()[agent] / crowd.scales()[agent]};
}

}  // namespace

PlacedFeet::PlacedFeet(std::vector<std::optional<anim::EntityPools::Kind>> kinds, anim::AnimationSystem& system)
    : kinds_(std::move(kinds)), not_given_(kinds_.size()), system_(&system) {}

void PlacedFeet::reset(std::size_t agents) {
  now_.feet.assign(agents, {});
  now_.have.clear();
  now_.have.reserve(agents);
  const std::size_t usual = std::min(agents, usually_near_by);
  for (std::uint32_t character = 0; character < kinds_.size(); ++character) {
    if (!kinds_[character]) continue;
    system_->characters().reserve_entities(*kinds_[character], usual, character);
    while (not_given_[character].size() < usual)
      not_given_[character].push_back(std::make_unique<Process>(*kinds_[character]));
  }
}

std::unique_ptr<PlacedFeet::Process> PlacedFeet::make(std::uint32_t character) {
  std::vector<std::unique_ptr<Process>>& ready = not_given_[character];
  if (ready.empty()) return std::make_unique<Process>(*kinds_[character]);
  std::unique_ptr<Process> one = std::move(ready.back());
  ready.pop_back();
  return one;
}

// A local store that has no room for it will have none for others.
bool PlacedFeet::give(std::uint32_t agent, bool is_shown) {
  const std::uint32_t character = system_->agent(agent).character_number();
  if (!kinds_[character]) return false;
  Feet& feet = now_.feet[agent];
  if (feet.process.valid()) return true;
  std::unique_ptr<Process> process = make(character);
  *process = Process(*kinds_[character]);
  process->set_weight(1.0F, is_shown ? fade : anim::Ticks{});
  const anim::Result<anim::ProcessId> added = system_->agent(agent).add_post_process(std::move(process));
  if (!added) {
    kinds_[character].reset();
    return false;
  }
  feet = {.process = *added, .placed = true};
  now_.have.push_back(agent);
  return true;
}

void PlacedFeet::place(const Crowd& crowd, std::uint32_t agent, bool is_shown, std::span<const float> planted) {
  if (!give(agent, is_shown)) return;
  const bool begins = !std::exchange(now_.feet[agent].placed, true);
  [[maybe_unused]] const anim::Status placed =
      system_->agent(agent).change_process<anim::FootPlacementProcess>(now_.feet[agent].process, [&](auto& feet) {
        const anim::JointMotion placement = placement_of(crowd, agent);
        feet.set_placement(placement);
        feet.set_ground({.place = placement.position});  // the tier of a stadium that it stands on
        for (int leg = 0; const float firmly : planted) feet.set_planted(leg++, firmly);
        if (begins) feet.set_weight(1.0F, is_shown ? fade : anim::Ticks{});
      });
  assert(placed && "the graph is as large as it was");
}

void PlacedFeet::let_go(std::uint32_t agent) {
  if (!std::exchange(now_.feet[agent].placed, false)) return;
  [[maybe_unused]] const anim::Status let_go = system_->agent(agent).change_process<anim::FootPlacementProcess>(
      now_.feet[agent].process, [](auto& feet) { feet.set_weight(0.0F, fade); });
  assert(let_go && "the graph is as large as it was");
}

bool PlacedFeet::needs(std::uint32_t agent, std::span<const anim::VisibleAgent> visible) const {
  const Feet& feet = now_.feet[agent];
  const anim::AgentView posed = system_->agent(agent);
  if (feet.process != posed.post_process_id(posed.post_process_count() - 1)) return true;  // a rag-doll came after it
  if (!std::ranges::binary_search(visible, agent, {}, &anim::VisibleAgent::agent)) return false;
  return feet.placed || posed.post_process<Process>(feet.process)->weight(posed.pools()) > 0.0F;
}

void PlacedFeet::take_back(std::span<const anim::VisibleAgent> visible) {
  std::erase_if(now_.have, [&](std::uint32_t agent) {
    if (needs(agent, visible)) return false;
    std::unique_ptr<Process> process = system_->agent(agent).take_post_process<Process>(now_.feet[agent].process);
    std::vector<std::unique_ptr<Process>>& ready = not_given_[system_->agent(agent).character_number()];
    if (ready.size() < ready.capacity()) ready.push_back(std::move(process));
    now_.feet[agent] = {};
    return true;
  });
}

}  // namespace throng::app
