#pragma once

#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

namespace throng::anim {

/// One stretch of a PU's time within an update.
struct TraceSpan {
  enum class Kind : std::uint8_t { fetch, compute, write_back };
  Kind kind;
  float begin_ms;  ///< since the update began
  float end_ms;
};

/// What one PU did, span by span, in memory set aside beforehand; what does not fit is not kept.
class Trace {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t most_spans = 512;

  Trace() { spans_.reserve(most_spans); }

  void begin(Clock::time_point update_start) {
    spans_.clear();
    start_ = update_start;
  }
  /// Does `work` as a span of that kind.
  template <typename Work>
  void record(TraceSpan::Kind kind, Work&& work) {
    if (spans_.size() == most_spans) return work();
    const Clock::time_point begin = Clock::now();
    work();
    spans_.push_back({kind, since_start(begin), since_start(Clock::now())});
  }
  std::span<const TraceSpan> spans() const { return spans_; }

 private:
  float since_start(Clock::time_point time) const {
    return std::chrono::duration<float, std::milli>(time - start_).count();
  }

  std::vector<TraceSpan> spans_;
  Clock::time_point start_;
};

}  // namespace throng::anim
