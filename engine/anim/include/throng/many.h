#pragma once

#include "throng/agent.h"
#include "throng/ids.h"
#include "throng/math.h"
#include "throng/processes.h"
#include "throng/standard.h"
#include "throng/ticks.h"

/// Requests to many agents at a time. A call does what one call for each element does, on all PUs of the crowd. A call
/// about fewer than 512 elements wakes no other PU.
namespace throng {

/// A request as Agent::set_speed takes it.
struct SpeedRequest {
  AgentId agent{};
  float speed = 1.0F;  ///< multiple of the clip's own
};

/// A request as Agent::set_parameter takes it, which reads x alone; of a plane, as set_parameters takes it.
struct ParameterRequest {
  AgentId agent{};
  ChannelId channel{};
  float x = 0.0F;
  float y = 0.0F;
};

/// A request as Processes::look_at takes it.
struct GazeRequest {
  AgentId agent{};
  ProcessId gaze{};
  Vec3 target{};
  Ticks fade{};
};

/// A request as Processes::reach takes it.
struct ReachRequest {
  AgentId agent{};
  ProcessId limb{};
  Vec3 target{};
};

/// A request as Processes::set_placement takes it.
struct PlacementRequest {
  AgentId agent{};
  ProcessId process{};
  Place model_in_world{};
};

/// A request as Processes::set_ground takes it.
struct GroundRequest {
  AgentId agent{};
  ProcessId feet{};
  int leg = -1;  ///< -1: all
  Vec3 point{};
  Vec3 normal{0.0F, 1.0F, 0.0F};
};

/// A data key, and the agent that met it.
struct AgentKey {
  AgentId agent{};
  DataKey key{};
};

/// A process of an agent, such as a socket.
struct ProcessOf {
  AgentId agent{};
  ProcessId process{};
};

/// Takes requests to many agents at a time, and tells how they move. Requests and answers are the caller's memory. A
/// request that cannot be met is left out: the call then returns false, and reports one such request as a misuse
/// (host.h). An agent may come several times, which is fastest one after the other, as the legs of a foot placement
/// are.
class ManyAgents {
 public:
  explicit ManyAgents(detail::CrowdParts& crowd) : crowd_(&crowd) {}

  bool set_speeds(std::span<const SpeedRequest> requests) const;
  bool set_parameters(std::span<const ParameterRequest> requests) const;
  bool look_at(std::span<const GazeRequest> requests) const;
  bool reach(std::span<const ReachRequest> requests) const;
  bool set_placements(std::span<const PlacementRequest> requests) const;
  bool set_grounds(std::span<const GroundRequest> requests) const;

  /// Writes Motion::displacement of each agent. `into` has an element for each; an agent that is gone gets zeros.
  bool displacements(Ticks from, Ticks to, std::span<const AgentId> agents, std::span<RootMotion> into) const;
  /// Returns what Motion::for_each_key visits, agent after agent. The span is valid until keys() is called again.
  std::span<const AgentKey> keys(Ticks from, Ticks to, std::span<const AgentId> agents,
                                 KeyChoice choice = KeyChoice::felt) const;
  /// Writes Processes::socket of each. `into` has an element for each.
  bool sockets(std::span<const ProcessOf> sockets, std::span<Place> into) const;

 private:
  detail::CrowdParts* crowd_;
};

}  // namespace throng
