#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "throng/many.h"

#include "engine/anim/agent/agent.h"
#include "engine/anim/base/zone.h"
#include "engine/base/run_jobs.h"

namespace throng::anim {

/// Takes requests to many agents at a time, on all PUs: an element is a struct of throng/many.h, which names its agent.
/// A request that cannot be met is left out; a call returns false if there was one, and reports one of them as a misuse
/// of `call`.
///
///     1. all requests     on all PUs, where the agent keeps its entities, and no request before names it, but for the
///                         requests right before
///     2. the remaining    in the caller's thread, in their order
class ManyRequests {
 public:
  explicit ManyRequests(SystemParts& system) : system_(&system) {}

  bool set_speeds(std::span<const SpeedRequest> requests, const char* call = "ManyAgents::set_speeds") const;
  bool set_parameters(std::span<const ParameterRequest> requests,
                      const char* call = "ManyAgents::set_parameters") const;
  bool look_at(std::span<const GazeRequest> requests, const char* call = "ManyAgents::look_at") const;
  bool reach(std::span<const ReachRequest> requests, const char* call = "ManyAgents::reach") const;
  bool set_placements(std::span<const PlacementRequest> requests,
                      const char* call = "ManyAgents::set_placements") const;
  bool set_grounds(std::span<const GroundRequest> requests, const char* call = "ManyAgents::set_grounds") const;

  /// Calls read(run, first, end) for runs of the numbers below `count`, at most one a PU, on all PUs. It reads from
  /// agents and changes none. `call` names the zones.
  template <typename Read>
  void read_runs(const char* call, std::size_t count, const Read& read) const {
    const auto pus = static_cast<std::size_t>(system_->pus.options().pus);
    const std::size_t runs = std::clamp<std::size_t>(count / requests_a_job, 1, pus);
    const auto run = [&](std::size_t i) {
      const Zone zone(call, static_cast<int>(i));
      read(i, count * i / runs, count * (i + 1) / runs);
    };
    if (runs == 1) return run(0);
    run_jobs(system_->pus.executor(), runs, run);
  }
  /// Calls read(i) for each i below `count` in this way.
  template <typename Read>
  void read(const char* call, std::size_t count, const Read& read) const {
    read_runs(call, count, [&](std::size_t, std::size_t first, std::size_t end) {
      for (std::size_t i = first; i < end; ++i) read(i);
    });
  }

 private:
  static constexpr std::size_t requests_a_job = 256;

  /// What became of a request: why it cannot be met, or that it waits for the caller's thread.
  struct Outcome {
    const char* fault = nullptr;
    bool waits = false;
  };
  template <typename Request, typename TakeInPlace, typename TakeAlone>
  bool take(std::span<const Request> requests, const char* call, const TakeInPlace& in_place,
            const TakeAlone& alone) const;
  template <typename... Parts, typename Request, typename Part, typename FaultOf, typename Set>
  bool take_parts(std::span<const Request> requests, const char* call, Part Request::*part, const FaultOf& fault_of,
                  const Set& set) const;

  SystemParts* system_;
};

}  // namespace throng::anim
