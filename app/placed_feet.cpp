#include "app/placed_feet.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>
#include <utility>

#include <glm/gtc/quaternion.hpp>

namespace throng::app {
namespace {

constexpr anim::Ticks fade = anim::ticks_per_second / 5;

// The model is as large as its agent is tall, so the world is measured in the agent's own size.
anim::JointMotion placement_of(const Crowd& crowd, std::uint32_t agent) {
  const Heading heading = crowd.headings()[agent];
  const float half_cosine = std::sqrt(std::max(0.0F, 0.5F + 0.5F * heading.cosine));
  const float half_sine = std::copysign(std::sqrt(std::max(0.0F, 0.5F - 0.5F * heading.cosine)), heading.sine);
  return {.rotation = {half_cosine, 0.0F, half_sine, 0.0F},
          .position = crowd.positions()[agent] / crowd.scales()[agent]};
}

}  // namespace

void PlacedFeet::reset(std::size_t agents) { feet_.assign(agents, {}); }

// A local store that has no room for it will have none for others.
bool PlacedFeet::give(std::uint32_t agent) {
  std::optional<anim::EntityPools::Kind>& kind = kinds_[system_->character_number(agent)];
  if (!kind) return false;
  if (feet_[agent].process != none) return true;
  const std::size_t process = system_->post_process_count(agent);
  if (!system_->add_post_process(agent, std::make_unique<anim::FootPlacementProcess>(*kind))) {
    kind.reset();
    return false;
  }
  feet_[agent] = {.process = process, .placed = true};
  return true;
}

void PlacedFeet::place(const Crowd& crowd, std::uint32_t agent) {
  if (!give(agent)) return;
  const bool begins = !std::exchange(feet_[agent].placed, true);
  [[maybe_unused]] const anim::Status placed =
      system_->change_process<anim::FootPlacementProcess>(agent, feet_[agent].process, [&](auto& feet) {
        const anim::JointMotion placement = placement_of(crowd, agent);
        feet.set_placement(placement);
        feet.set_ground({.place = placement.position});  // the tier of a stadium that it stands on
        if (begins) feet.set_weight(1.0F, fade);
      });
  assert(placed && "the graph is as large as it was");
}

void PlacedFeet::let_go(std::uint32_t agent) {
  if (!std::exchange(feet_[agent].placed, false)) return;
  [[maybe_unused]] const anim::Status let_go = system_->change_process<anim::FootPlacementProcess>(
      agent, feet_[agent].process, [](auto& feet) { feet.set_weight(0.0F, fade); });
  assert(let_go && "the graph is as large as it was");
}

}  // namespace throng::app
