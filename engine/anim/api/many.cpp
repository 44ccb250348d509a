#include "throng/many.h"

#include <algorithm>
#include <atomic>

#include "engine/anim/agent/socket_process.h"
#include "engine/anim/api/crowd_parts.h"
#include "engine/anim/base/misuse.h"
#include "engine/anim/kernel/limb/joint_place.h"

namespace throng {
namespace {

constexpr const char* no_room = "there is no room for the answer of each agent";

/// Notes from all PUs whether each agent could be asked, to be reported once.
class Outcome {
 public:
  /// Returns `is_well`, and notes if it is not.
  bool note(bool is_well) {
    if (!is_well) all_.store(false, std::memory_order_relaxed);
    return is_well;
  }
  bool report(const char* call, const char* fault) const { return all_.load() || anim::report_misuse({call, fault}); }

 private:
  std::atomic<bool> all_{true};
};

}  // namespace

bool ManyAgents::set_speeds(std::span<const SpeedRequest> requests) const {
  return crowd_->system->many().set_speeds(requests);
}
bool ManyAgents::set_parameters(std::span<const ParameterRequest> requests) const {
  return crowd_->system->many().set_parameters(requests);
}
bool ManyAgents::look_at(std::span<const GazeRequest> requests) const {
  return crowd_->system->many().look_at(requests);
}
bool ManyAgents::reach(std::span<const ReachRequest> requests) const { return crowd_->system->many().reach(requests); }
bool ManyAgents::set_placements(std::span<const PlacementRequest> requests) const {
  return crowd_->system->many().set_placements(requests);
}
bool ManyAgents::set_grounds(std::span<const GroundRequest> requests) const {
  return crowd_->system->many().set_grounds(requests);
}

bool ManyAgents::displacements(Ticks from, Ticks to, std::span<const AgentId> agents,
                               std::span<RootMotion> into) const {
  constexpr const char* call = "ManyAgents::displacements";
  if (into.size() < agents.size()) return anim::report_misuse({call, no_room});
  if (!crowd_->are_near(from, to, call)) return false;
  Outcome outcome;
  crowd_->system->many().read(call, agents.size(), [&](std::size_t i) {
    const bool is_here = outcome.note(Agent(*crowd_, agents[i]).exists());
    into[i] = is_here ? Motion(*crowd_, agents[i]).displacement(from, to) : RootMotion{};
  });
  return outcome.report(call, detail::no_agent);
}

// Each job lists the keys of a run of agents, so that the whole list has their order.
std::span<const AgentKey> ManyAgents::keys(Ticks from, Ticks to, std::span<const AgentId> agents,
                                           KeyChoice choice) const {
  constexpr const char* call = "ManyAgents::keys";
  if (!crowd_->is_asked_in_time(from, to, call)) return {};
  std::vector<std::vector<AgentKey>>& runs = crowd_->keys;
  const auto pus = static_cast<std::size_t>(crowd_->system->options().pus);
  runs.resize(std::max(runs.size(), pus));
  for (std::vector<AgentKey>& run : runs) run.clear();
  Outcome outcome;
  crowd_->system->many().read_runs(call, agents.size(), [&](std::size_t run, std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      if (!outcome.note(Agent(*crowd_, agents[i]).exists())) continue;
      Motion(*crowd_, agents[i])
          .for_each_key(
              from, to, [&](const DataKey& key) { runs[run].push_back({.agent = agents[i], .key = key}); }, choice);
    }
  });
  for (std::size_t run = 1; run < runs.size(); ++run) {
    runs.front().insert(runs.front().end(), runs[run].begin(), runs[run].end());
  }
  outcome.report(call, detail::no_agent);
  return runs.front();
}

bool ManyAgents::sockets(std::span<const ProcessOf> sockets, std::span<Place> into) const {
  constexpr const char* call = "ManyAgents::sockets";
  if (into.size() < sockets.size()) return anim::report_misuse({call, no_room});
  Outcome outcome;
  crowd_->system->many().read(call, sockets.size(), [&](std::size_t i) {
    const anim::AgentView agent = std::as_const(*crowd_->system).agent(sockets[i].agent);
    const auto* const own = agent.post_process<anim::SocketProcess>(sockets[i].process);
    into[i] = outcome.note(own != nullptr) ? anim::from_joint(own->motion(agent.pools())) : Place{};
  });
  return outcome.report(call, "an agent has no socket of this id");
}

}  // namespace throng
