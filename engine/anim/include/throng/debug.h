#pragma once

#include <cstddef>
#include <cstdint>

#include "throng/crowd.h"

namespace throng {

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
  /// Returns the bytes of main memory of an agent, without its palette.
  double bytes_per_agent() const;
  /// Returns the name of the instructions that the kernels were compiled for.
  const char* kernels() const;

 private:
  const detail::CrowdParts* crowd_;
};

}  // namespace throng
