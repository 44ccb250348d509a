#include "app/show/stage/placed_feet.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/quaternion.hpp>

namespace throng::app {
namespace {

constexpr Ticks fade = ticks_per_second / 5;

// The model is as large as its agent is tall, so the world is measured in the agent's own size.
anim::JointMotion placement_of(const Crowd& crowd, std::uint32_t agent) {
  const Heading heading = crowd.headings()[agent];
  const float half_cosine = std::sqrt(std::max(0.0F, 0.5F + 0.5F * heading.cosine));
  const float half_sine = std::copysign(std::sqrt(std::max(0.0F, 0.5F - 0.5F * heading.cosine)), heading.sine);
  return {.rotation = {half_cosine, 0.0F, half_sine, 0.0F},
          .position = crowd.positions()[agent] / crowd.scales()[agent]};
}

}  // namespace

void PlacedFeet::place(const Crowd& crowd, std::uint32_t agent, bool is_shown, std::span<const float> planted) {
  const Ticks begin = is_shown ? fade : Ticks{};
  const Lent lent = lend(agent, [begin](anim::EntityPools::Kind kind) {
    anim::FootPlacementProcess feet(kind);
    feet.set_weight(1.0F, begin);
    return feet;
  });
  if (lent == Lent::no) return;
  change(agent, [&](anim::FootPlacementProcess& feet) {
    const anim::JointMotion placement = placement_of(crowd, agent);
    feet.set_placement(placement);
    feet.set_ground({.place = placement.position});  // the tier of a stadium that it stands on
    for (int leg = 0; const float firmly : planted) feet.set_planted(leg++, firmly);
    if (lent == Lent::again) feet.set_weight(1.0F, begin);
  });
}

void PlacedFeet::let_go(std::uint32_t agent) { LentProcesses::let_go(agent, fade); }

}  // namespace throng::app
