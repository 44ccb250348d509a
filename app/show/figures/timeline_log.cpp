#include "app/show/figures/timeline_log.h"

#include <algorithm>
#include <cstdio>

#include "engine/anim/agent/animation_system.h"

namespace throng::app {
namespace {

template <typename... Values>
void append(std::string& text, const char* format, Values... values) {
  char line[256];
  const int length = std::snprintf(line, sizeof(line), format, values...);
  text.append(line, static_cast<std::size_t>(std::min<int>(length, sizeof(line) - 1)));
}

}  // namespace

// Appends nothing where no bytes were copied and no agents posed.
void TimelineLog::append_arguments(std::string& text, const Event& event) {
  if (event.transfers == 0 && event.content.agents == 0) return;
  append(text, ",\"args\":{\"bytes_in\":%u,\"bytes_out\":%u,\"transfers\":%u", event.bytes_in, event.bytes_out,
         event.transfers);
  if (event.content.agents > 0) {
    append(text, ",\"agents\":%u,\"first_agent\":%u,\"last_agent\":%u", static_cast<unsigned>(event.content.agents),
           event.content.first_agent, event.content.last_agent);
  }
  text += '}';
}

double TimelineLog::since_start(Clock::time_point time) const {
  return std::chrono::duration<double, std::micro>(time - start_).count();
}

void TimelineLog::add(const Event& event) {
  frames_.back().events.push_back(event);
  ++spans_;
}

void TimelineLog::add_part(std::uint32_t lane, Clock::time_point begin, Clock::time_point end) {
  if (frames_.empty()) return;
  (lane == drawing_lane ? draws_ : has_overlay_) = true;
  const double from = since_start(begin);
  add({.begin_us = from,
       .length_us = static_cast<float>(since_start(end) - from),
       .lane = lane,
       .name = lane == drawing_lane ? "draw" : "overlay"});
}

void TimelineLog::add_update(const anim::AnimationSystem& system, Clock::time_point frame_start,
                             const TraceCounters& counters) {
  if (frames_.empty()) start_ = frame_start;
  const double frame_us = since_start(frame_start);
  frames_.push_back({.begin_us = frame_us, .counters = counters, .events = {}});
  spans_ += counters_a_frame;
  add({.begin_us = frame_us,
       .length_us = static_cast<float>(since_start(Clock::now()) - frame_us),
       .lane = 0,
       .name = "update"});
  const anim::UpdateTime& time = system.figures().update_time();
  const double update_us = since_start(time.start);
  std::uint32_t lane = 0;
  for (const anim::ProcessingUnit& unit : system.figures().units()) {
    ++lane;
    not_kept_ += unit.trace().not_kept();
    for (const anim::TraceSpan& span : unit.trace().spans()) {
      const double begin = time.ms(span.begin) * 1000.0;
      add({.begin_us = update_us + begin,
           .length_us = static_cast<float>(time.ms(span.end) * 1000.0 - begin),
           .lane = lane,
           .name = anim::name_of(span.kind),
           .bytes_in = span.bytes_in,
           .bytes_out = span.bytes_out,
           .transfers = span.transfers,
           .content = span.content});
    }
  }
  lanes_ = std::max(lanes_, lane + 1);
  while (spans_ > most_spans && frames_.size() > 1) {
    spans_ -= frames_.front().size();
    frames_.pop_front();
  }
}

void TimelineLog::append_lane_names(std::string& text) const {
  const auto append_name = [&text](std::uint32_t lane, const std::string& name) {
    append(text, ",\n{\"ph\":\"M\",\"pid\":1,\"tid\":%u,\"name\":\"thread_name\",\"args\":{\"name\":\"%s\"}}", lane,
           name.c_str());
  };
  for (std::uint32_t lane = 0; lane < lanes_; ++lane) {
    append_name(lane, lane == 0 ? "frame" : "PU " + std::to_string(lane - 1));
  }
  if (draws_) append_name(drawing_lane, "drawing");
  if (has_overlay_) append_name(overlay_lane, "overlay");
}

void TimelineLog::append_event(std::string& text, const Event& event, std::uint64_t frame) {
  append(text, ",\n{\"ph\":\"X\",\"pid\":1,\"tid\":%u,\"ts\":%.3f,\"dur\":%.3f,\"name\":\"%s\"", event.lane,
         event.begin_us, static_cast<double>(event.length_us), event.name);
  const bool of_a_pu = event.lane > 0 && event.lane < drawing_lane;
  if (of_a_pu) {
    append_arguments(text, event);
  } else {
    append(text, ",\"args\":{\"frame\":%llu}", static_cast<unsigned long long>(frame));
  }
  text += '}';
}

void TimelineLog::append_counters(std::string& text, const Frame& frame) {
  const auto append_counter = [&](const char* name, const char* unit, double value) {
    append(text, ",\n{\"ph\":\"C\",\"pid\":1,\"ts\":%.3f,\"name\":\"%s\",\"args\":{\"%s\":%.6g}}", frame.begin_us, name,
           unit, value);
  };
  append_counter("agents updated", "agents", frame.counters.agents_updated);
  append_counter("update", "ms", frame.counters.update_ms);
  append_counter("error p99", "pixels", static_cast<double>(frame.counters.error_p99_px));
  append_counter("pop", "pixels", static_cast<double>(frame.counters.pop_px));
}

std::string TimelineLog::to_json() const {
  std::string text = "{\"displayTimeUnit\":\"ms\",\"otherData\":{\"spans_not_kept\":" + std::to_string(not_kept_) +
                     "},\"traceEvents\":[\n";
  append(text, "{\"ph\":\"M\",\"pid\":1,\"tid\":0,\"name\":\"process_name\",\"args\":{\"name\":\"throng\"}}");
  append_lane_names(text);
  for (const Frame& frame : frames_) {
    for (const Event& event : frame.events) append_event(text, event, frame.counters.frame);
    append_counters(text, frame);
  }
  return text + "\n]}\n";
}

}  // namespace throng::app
