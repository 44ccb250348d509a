#pragma once

#include <cstddef>
#include <cstdint>

#include "throng/crowd.h"
#include "throng/standard.h"

namespace throng {

/// A stretch of a PU's time within an update.
struct PuSpan {
  const char* name;         ///< "fetch", "compute", "write back", "wait" or "schedule"; it lives as long as the program
  std::int64_t begin;       ///< nanoseconds of std::chrono::steady_clock
  std::int64_t end;         ///< where the next one begins
  std::uint32_t agents;     ///< the number of agents that it was for; 0: it was for none, or for what agents share
  std::uint32_t bytes_in;   ///< bytes that were copied into the local store
  std::uint32_t bytes_out;  ///< bytes that were copied out of it
};

/// Tells a profiler or a test what a crowd did and what it takes. A game needs none of it.
class Debug {
 public:
  explicit Debug(const detail::CrowdParts& crowd) : crowd_(&crowd) {}

  /// Returns the hash of all palettes so far; see CrowdOptions::hash.
  std::uint64_t pose_hash() const;
  /// Returns how many agents the last update posed.
  std::uint32_t posed_agents() const;
  /// Returns the predicted time of the last update, on one PU.
  double predicted_nanoseconds() const;
  /// Returns the time that the last update took, from call to return.
  double update_milliseconds() const;
  /// Returns what a PU did in the last update, without gaps, from the first span to the last; see CrowdOptions::trace.
  /// A "compute" span is one tile or several short ones, and has most copies. A PU keeps 65,536 spans. It allocates.
  /// The list is empty if the crowd has no such PU or records no trace.
  std::vector<PuSpan> trace(int pu) const;
  /// Returns the bytes of main memory of an agent, without its palette.
  double bytes_per_agent() const;
  /// Returns the name of the instructions that the kernels were compiled for.
  const char* kernels() const;

 private:
  const detail::CrowdParts* crowd_;
};

}  // namespace throng
