#include "app/figures/timeline_log.h"

#include <algorithm>
#include <cstdio>

namespace throng::app {
namespace {

const char* name_of(anim::TraceSpan::Kind kind) {
  switch (kind) {
    case anim::TraceSpan::Kind::fetch:
      return "fetch";
    case anim::TraceSpan::Kind::compute:
      return "compute";
    case anim::TraceSpan::Kind::write_back:
      return "write back";
    case anim::TraceSpan::Kind::wait:
      return "wait";
    case anim::TraceSpan::Kind::schedule:
      return "schedule";
    case anim::TraceSpan::Kind::copy_slice:
      break;
  }
  return "copy slice";
}

template <typename... Values>
void append(std::string& text, const char* format, Values... values) {
  char line[256];
  const int length = std::snprintf(line, sizeof(line), format, values...);
  text.append(line, static_cast<std::size_t>(std::min<int>(length, sizeof(line) - 1)));
}

}  // namespace

// Nothing where nothing was copied for nobody.
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
  frames_.back().push_back(event);
  ++spans_;
}

void TimelineLog::add_part(const char* name, Clock::time_point begin, Clock::time_point end) {
  if (frames_.empty()) return;
  const double from = since_start(begin);
  add({.begin_us = from, .length_us = static_cast<float>(since_start(end) - from), .lane = 0, .name = name});
}

void TimelineLog::add_update(const anim::AnimationSystem& system, Clock::time_point frame_start) {
  if (frames_.empty()) start_ = frame_start;
  frames_.emplace_back();
  add_part("update", frame_start, Clock::now());
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
           .name = name_of(span.kind),
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

std::string TimelineLog::to_json() const {
  std::string text = "{\"displayTimeUnit\":\"ms\",\"otherData\":{\"spans_not_kept\":" + std::to_string(not_kept_) +
                     "},\"traceEvents\":[\n";
  append(text, "{\"ph\":\"M\",\"pid\":1,\"tid\":0,\"name\":\"process_name\",\"args\":{\"name\":\"throng\"}}");
  for (std::uint32_t lane = 0; lane < lanes_; ++lane) {
    const std::string name = lane == 0 ? "frame" : "PU " + std::to_string(lane - 1);
    append(text, ",\n{\"ph\":\"M\",\"pid\":1,\"tid\":%u,\"name\":\"thread_name\",\"args\":{\"name\":\"%s\"}}", lane,
           name.c_str());
  }
  for (const std::vector<Event>& frame : frames_) {
    for (const Event& event : frame) {
      append(text, ",\n{\"ph\":\"X\",\"pid\":1,\"tid\":%u,\"ts\":%.3f,\"dur\":%.3f,\"name\":\"%s\"", event.lane,
             event.begin_us, static_cast<double>(event.length_us), event.name);
      append_arguments(text, event);
      text += '}';
    }
  }
  return text + "\n]}\n";
}

}  // namespace throng::app
