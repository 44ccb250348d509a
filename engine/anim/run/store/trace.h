#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/anim/base/room.h"
#include "engine/anim/base/zone.h"
#include "engine/anim/run/program/task_content.h"
#include "engine/anim/run/store/schedule.h"
#include "engine/base/compiler.h"

namespace throng::anim {

/// A clock that counts up at an even rate, the same on all cores. It is the processor's time stamp if there is one,
/// because a span takes microseconds and the system's clock a fiftieth of one. UpdateTime finds its rate by comparing
/// both clocks over a whole update.
struct TraceClock {
  static std::uint64_t now() {
#if defined(THRONG_HAS_TIME_STAMP)
    return time_stamp();
#else
    return static_cast<std::uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count());
#endif
  }
};

/// One stretch of a PU's time within an update; 48 bytes.
struct TraceSpan {
  enum class Kind : std::uint8_t {
    fetch,       ///< copies of the next task in and, with double buffering, of the previous one out
    compute,     ///< computing; with interleaved double buffering the same copies, asked for in slices, too
    write_back,  ///< copies of the last task out
    wait,        ///< waiting for the other PUs, or to be woken
    schedule,    ///< PU 0 sorts and cuts tiles
    copy_slice,  ///< a slice of copies within a compute span; recorded for one task in many
  };
  std::uint64_t begin;  ///< tick of TraceClock
  std::uint64_t end;
  std::uint32_t bytes_in;  ///< copied within the span
  std::uint32_t bytes_out;
  std::uint32_t transfers;
  Kind kind;
  TaskContent content{};
};
static_assert(sizeof(TraceSpan) == 48);

constexpr const char* name_of(TraceSpan::Kind kind) {
  constexpr std::array names{"fetch", "compute", "write back", "wait", "schedule", "copy slice"};
  return names[static_cast<std::size_t>(kind)];
}

/// Bytes and transfers of copies.
struct CopyCounts {
  std::uint64_t bytes_in = 0;
  std::uint64_t bytes_out = 0;
  std::uint64_t transfers = 0;

  friend CopyCounts operator-(const CopyCounts& a, const CopyCounts& b) {
    return {a.bytes_in - b.bytes_in, a.bytes_out - b.bytes_out, a.transfers - b.transfers};
  }
  CopyCounts& operator+=(const CopyCounts& other) {
    bytes_in += other.bytes_in;
    bytes_out += other.bytes_out;
    transfers += other.transfers;
    return *this;
  }
};

/// The times when an update began and ended, on both clocks.
struct UpdateTime {
  std::chrono::steady_clock::time_point start{};
  double milliseconds = 0;
  std::uint64_t first_tick = 0;
  std::uint64_t last_tick = 0;

  void begin() {
    start = std::chrono::steady_clock::now();
    first_tick = TraceClock::now();
  }
  void end() {
    milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    last_tick = std::max(TraceClock::now(), first_tick + 1);
  }
  /// Returns the milliseconds from the start of the update to a tick.
  double ms(std::uint64_t tick) const {
    const auto whole = static_cast<double>(last_tick - first_tick);
    return static_cast<double>(std::max(tick, first_tick) - first_tick) / whole * milliseconds;
  }
};

/// The spans of one PU in an update, without gaps: each begins where the one before it ended. They lie in memory set
/// aside beforehand; spans that do not fit are counted and not kept. The profiler of a host hears of each task's spans
/// as they begin and end, recorded or not.
class Trace {
 public:
  static constexpr std::uint32_t slices_of_one_task_in = 64;
  static constexpr double shortest_span_ns =
      4000;  ///< by prediction: a hundred times what reading the clock takes, thrice

  /// Makes room for so many spans. The trace records nothing if they are 0.
  void reserve(std::size_t spans, Tracing tracing) {
    spans_.clear();
    make_room(spans_, spans);
    room_ = spans;
    every_task_ = tracing == Tracing::every_task;
  }

  void begin(std::uint64_t tick, int pu = 0) {
    spans_.clear();
    zones_ = zone_hooks();
    pu_ = pu;
    zone_is_open_ = false;
    last_ = tick;
    not_kept_ = 0;
    tasks_ = 0;
  }

  /// Begins tasks that take about so many nanoseconds each, up to end_tasks().
  void begin_tasks(double task_ns) {
    tasks_in_span_ = every_task_ ? 1 : static_cast<std::uint32_t>(1 + shortest_span_ns / std::max(task_ns, 10.0));
    if (task_ns >= shortest_span_ns) tasks_in_span_ = 1;
  }
  void end_tasks() {
    if (joined_tasks_ > 0 || joined_copies_.transfers > 0) close_joined();
    tasks_in_span_ = 1;
  }

  bool records() const { return room_ > 0; }

  /// Tells the host's profiler that a span of this kind begins on this thread. The next close() tells that it ends.
  void open(TraceSpan::Kind kind) {
    if (zones_.begin == nullptr || zone_is_open_) return;
    zones_.begin(name_of(kind), pu_, zones_.context);
    zone_is_open_ = true;
  }

  /// Ends a span. The time since the last one was spent in this way, for these agents.
  void close(TraceSpan::Kind kind, const CopyCounts& copied = {}, const TaskContent& content = {}) {
    if (std::exchange(zone_is_open_, false)) zones_.end(pu_, zones_.context);
    if (!records()) return;
    if (tasks_in_span_ > 1) {
      joined_copies_ += copied;
      if (kind == TraceSpan::Kind::compute) joined_content_.add(content);
      copied_content_ = content;
      if (kind == TraceSpan::Kind::compute && ++joined_tasks_ == tasks_in_span_) close_joined();
      return;
    }
    const std::uint64_t now = TraceClock::now();
    add(kind, last_, now, copied, content);
    last_ = now;
  }

  /// Ends a span that is never joined with others, for work that is done once for many tasks.
  void close_alone(TraceSpan::Kind kind, const CopyCounts& copied, const TaskContent& content) {
    const std::uint32_t joining = std::exchange(tasks_in_span_, 1U);
    if (joined_tasks_ > 0) close_joined();
    close(kind, copied, content);
    tasks_in_span_ = joining;
  }

  /// Returns true for one task in many. The slices of its copies are recorded, too.
  bool wants_slices() { return room_ > 0 && tasks_in_span_ == 1 && tasks_++ % slices_of_one_task_in == 0; }
  void add_slice(std::uint64_t begin) { add(TraceSpan::Kind::copy_slice, begin, TraceClock::now(), {}, {}); }

  std::span<const TraceSpan> spans() const { return spans_; }
  std::uint32_t not_kept() const { return not_kept_; }

 private:
  void close_joined() {
    const std::uint64_t now = TraceClock::now();
    add(TraceSpan::Kind::compute, last_, now, joined_copies_,
        joined_tasks_ > 0 ? joined_content_.all() : copied_content_);
    last_ = now;
    joined_tasks_ = 0;
    joined_copies_ = {};
    joined_content_ = {};
  }
  void add(TraceSpan::Kind kind, std::uint64_t begin, std::uint64_t end, const CopyCounts& copied,
           const TaskContent& content) {
    if (spans_.size() == room_) {
      ++not_kept_;
      return;
    }
    spans_.push_back({.begin = begin,
                      .end = end,
                      .bytes_in = static_cast<std::uint32_t>(copied.bytes_in),
                      .bytes_out = static_cast<std::uint32_t>(copied.bytes_out),
                      .transfers = static_cast<std::uint32_t>(copied.transfers),
                      .kind = kind,
                      .content = content});
  }

  std::vector<TraceSpan> spans_;
  std::size_t room_ = 0;
  std::uint64_t last_ = 0;
  std::uint32_t not_kept_ = 0;
  std::uint32_t tasks_ = 0;
  bool every_task_ = false;
  std::uint32_t tasks_in_span_ = 1;
  std::uint32_t joined_tasks_ = 0;  // the tasks of the span that is open
  CopyCounts joined_copies_;
  JoinedContent joined_content_;
  ZoneHooks zones_{};
  int pu_ = 0;
  bool zone_is_open_ = false;
  TaskContent copied_content_;  // the content of the task that was copied, or computed, last
};

}  // namespace throng::anim
