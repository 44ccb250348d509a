#pragma once

#include "engine/anim/run/store/copy_engine.h"
#include "engine/anim/run/store/schedule.h"
#include "engine/anim/run/store/trace.h"

namespace throng::anim {

template <typename Tasks, typename Task>
TaskContent recorded_content(const Tasks& tasks, const Task& task, const Trace& trace) {
  return trace.records() ? tasks.content(task) : TaskContent{};
}

/// Runs tasks through the local store. A kind of task must offer:
///   next()                          the next task of this PU, if any
///   fetch(task, buffer, engine)     queues the blocks that it reads
///   copy_points(task)               how often compute() calls engine.advance()
///   compute(task, buffer, engine)
///   write_back(task, buffer, engine) queues changed blocks that compute() has not written back
///   content(task)                   the agents that it is for
template <typename Tasks>
void run_single_buffered(Tasks& tasks, CopyEngine& engine, Trace& trace) {
  while (auto task = tasks.next()) {
    trace.open(TraceSpan::Kind::fetch);
    tasks.fetch(*task, 0, engine);
    const TaskContent content = recorded_content(tasks, *task, trace);
    trace.close(TraceSpan::Kind::fetch, engine.finish(), content);
    trace.open(TraceSpan::Kind::compute);
    tasks.compute(*task, 0, engine);
    trace.close(TraceSpan::Kind::compute, {}, content);
    trace.open(TraceSpan::Kind::write_back);
    tasks.write_back(*task, 0, engine);
    trace.close(TraceSpan::Kind::write_back, engine.finish(), content);
  }
}

template <typename Tasks>
void run_double_buffered(Tasks& tasks, CopyEngine& engine, DoubleBuffering mode, Trace& trace) {
  auto current = tasks.next();
  if (!current) return;
  int buffer = 0;
  trace.open(TraceSpan::Kind::fetch);
  tasks.fetch(*current, buffer, engine);
  TaskContent content = recorded_content(tasks, *current, trace);
  trace.close_alone(TraceSpan::Kind::fetch, engine.finish(), content);
  decltype(current) previous;
  while (current) {
    auto next = tasks.next();
    trace.open(mode == DoubleBuffering::inline_copy ? TraceSpan::Kind::fetch : TraceSpan::Kind::compute);
    if (previous) tasks.write_back(*previous, 1 - buffer, engine);
    if (next) tasks.fetch(*next, 1 - buffer, engine);
    const TaskContent next_content = next ? recorded_content(tasks, *next, trace) : content;
    if (mode == DoubleBuffering::inline_copy) trace.close(TraceSpan::Kind::fetch, engine.finish(), next_content);
    trace.open(TraceSpan::Kind::compute);
    engine.spread_over(tasks.copy_points(*current), &trace);
    tasks.compute(*current, buffer, engine);
    trace.close(TraceSpan::Kind::compute, engine.finish(), content);
    previous = current;
    current = next;
    content = next_content;
    buffer = 1 - buffer;
  }
  trace.open(TraceSpan::Kind::write_back);
  tasks.write_back(*previous, 1 - buffer, engine);
  trace.close_alone(TraceSpan::Kind::write_back, engine.finish(), content);
}

template <typename Tasks>
void run_tasks(Tasks& tasks, CopyEngine& engine, DoubleBuffering mode, Trace& trace) {
  if (mode == DoubleBuffering::off) {
    run_single_buffered(tasks, engine, trace);
  } else {
    run_double_buffered(tasks, engine, mode, trace);
  }
}

}  // namespace throng::anim
