#include "app/show/stage/fallen_agents.h"

#include <algorithm>
#include <memory>

namespace throng::app {
namespace {

using anim::RagdollProcess;

constexpr Ticks lies_for = 2 * ticks_per_second;
constexpr Ticks gets_up_in = ticks_per_second;
constexpr Ticks most_unrest = 12 * ticks_per_second;  // a restless agent gets up after this time too

}  // namespace

// The process stays once it is there: without a rag-doll it is nothing.
Status FallenAgents::push(std::uint32_t agent, const glm::vec3& impulse, const glm::vec3& place) {
  if (!process_of(agent)) {
    const Result<ProcessId> added = system_->agent(agent).add_post_process(
        std::make_unique<RagdollProcess>(*kinds_[system_->agent(agent).character_number()]));
    if (!added) return added.error();
    processes_.push_back({agent, *added});
  }
  Status pushed = system_->agent(agent).change_process<RagdollProcess>(
      *process_of(agent), [&](RagdollProcess& ragdoll) { ragdoll.push(impulse, place); });
  if (!pushed) return pushed;
  const auto found = std::ranges::find(fallen_, agent, &Fallen::agent);
  Fallen& fallen = found == fallen_.end() ? fallen_.emplace_back() : *found;
  fallen = {.agent = agent, .pushed_at = system_->clock()};
  left_out_[agent] = 1;
  return Done{};
}

bool FallenAgents::wants_up(Fallen& fallen) const {
  const RagdollProcess& ragdoll = process(fallen.agent);
  if (ragdoll.phase() != Phase::down) return false;
  const Ticks now = system_->clock();
  fallen.rests_since =
      ragdoll.is_asleep(system_->agent(fallen.agent).pools()) ? std::min(fallen.rests_since, now) : anim::never;
  return now - fallen.pushed_at >= most_unrest || (fallen.rests_since <= now && now - fallen.rests_since >= lies_for);
}

std::span<const std::uint32_t> FallenAgents::advance() {
  risen_.clear();
  for (Fallen& fallen : fallen_) {
    if (wants_up(fallen)) {
      // One that cannot get up for want of room in the local store is let go of, and then it stands.
      static_cast<void>(system_->agent(fallen.agent)
                            .change_process<RagdollProcess>(*process_of(fallen.agent), [](RagdollProcess& ragdoll) {
                              ragdoll.recover(gets_up_in);
                            }));
    }
    if (phase(fallen.agent) == Phase::standing) risen_.push_back(fallen.agent);
  }
  for (const std::uint32_t agent : risen_) left_out_[agent] = 0;
  std::erase_if(fallen_, [this](const Fallen& fallen) { return phase(fallen.agent) == Phase::standing; });
  return risen_;
}

std::optional<ProcessId> FallenAgents::process_of(std::uint32_t agent) const {
  const auto found = std::ranges::find(processes_, agent, &Process::agent);
  return found == processes_.end() ? std::nullopt : std::optional(found->id);
}

const RagdollProcess& FallenAgents::process(std::uint32_t agent) const {
  return *system_->agent(agent).post_process<RagdollProcess>(*process_of(agent));
}

FallenAgents::Phase FallenAgents::phase(std::uint32_t agent) const {
  return process_of(agent) ? process(agent).phase() : Phase::standing;
}

bool FallenAgents::at_rest(std::uint32_t agent) const {
  return phase(agent) == Phase::down && process(agent).is_asleep(system_->agent(agent).pools());
}

std::optional<glm::vec3> FallenAgents::hips(std::uint32_t agent) const {
  if (phase(agent) != Phase::down && phase(agent) != Phase::recovering) return std::nullopt;
  return process(agent).hips(system_->agent(agent).pools());
}

}  // namespace throng::app
