#include "app/show/report/tuning_sweep.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/anim/agent/animation_system.h"

namespace throng::app {
namespace {

constexpr double nanoseconds_a_microsecond = 1000;
constexpr int least_threads_tried = 4;  // also on a smaller machine, to show that more threads do not pay

std::vector<double> stops_of(SweptValue value, int threads) {
  switch (value) {
    case SweptValue::pus: {
      const int most = std::max(threads, least_threads_tried);
      std::vector<double> stops;
      for (int pus = 1; pus < most; pus *= 2) stops.push_back(pus);
      stops.push_back(most);
      return stops;
    }
    case SweptValue::local_store:
      return {local_store_stops.begin(), local_store_stops.end()};
    case SweptValue::tile:
      return {tile_stops.begin(), tile_stops.end()};
    case SweptValue::grain:
      break;
  }
  return {grain_stops.begin(), grain_stops.end()};
}

template <typename Figure>
Figure median_of(const std::vector<UpdateCost>& costs, Figure UpdateCost::*figure) {
  std::vector<Figure> values;
  values.reserve(costs.size());
  for (const UpdateCost& cost : costs) values.push_back(cost.*figure);
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

UpdateCost median_of(const std::vector<UpdateCost>& costs) {
  return {.milliseconds = median_of(costs, &UpdateCost::milliseconds),
          .tasks = median_of(costs, &UpdateCost::tasks),
          .bytes = median_of(costs, &UpdateCost::bytes)};
}

}  // namespace

UpdateCost cost_of_last_update(const anim::AnimationSystem& system) {
  const anim::CopyCounts& copied = system.figures().report().copies;
  UpdateCost cost{.milliseconds = system.figures().update_time().milliseconds,
                  .bytes = copied.bytes_in + copied.bytes_out};
  for (const anim::ProcessingUnit& unit : system.figures().units()) cost.tasks += unit.activity().tasks;
  return cost;
}

double swept_value(SweptValue value, const Tuning& tuning) {
  switch (value) {
    case SweptValue::pus:
      return tuning.system.pus;
    case SweptValue::local_store:
      return local_store_kib(tuning);
    case SweptValue::tile:
      return tuning.system.tile;
    case SweptValue::grain:
      break;
  }
  return tuning.system.cost.least_task / nanoseconds_a_microsecond;
}

void set_swept_value(SweptValue value, double to, Tuning& tuning) {
  const int whole = static_cast<int>(std::lround(to));
  switch (value) {
    case SweptValue::pus:
      tuning.system.pus = whole;
      break;
    case SweptValue::local_store:
      set_local_store_kib(tuning, whole);
      break;
    case SweptValue::tile:
      tuning.system.tile = whole;
      break;
    case SweptValue::grain:
      tuning.system.cost.least_task = to * nanoseconds_a_microsecond;
      break;
  }
}

const SweepStop* SweepCurve::lowest() const {
  const SweepStop* lowest = nullptr;
  for (const SweepStop& stop : stops) {
    if (!stop.known || stop.refused) continue;
    if (lowest == nullptr || stop.cost.milliseconds < lowest->cost.milliseconds) lowest = &stop;
  }
  return lowest;
}

void TuningSweep::start(SweptValue value, const Tuning& tuning, int threads) {
  start_ = tuning;
  curve_ = {.value = value, .stops = {}, .runs = true, .refusal = {}};
  for (const double stop : stops_of(value, threads)) curve_.stops.push_back({.value = stop});
  curve_.all_visits = rounds * static_cast<int>(curve_.stops.size());
  measured_.assign(curve_.stops.size(), {});
  stop_ = 0;
  round_ = frames_ = 0;
}

Tuning TuningSweep::tuning() const {
  assert(runs());
  Tuning tuning = start_;
  set_swept_value(curve_.value, curve_.stops[stop_].value, tuning);
  return tuning;
}

void TuningSweep::refuse(const std::string& reason) {
  assert(runs());
  if (curve_.refusal.empty()) curve_.refusal = reason;
  curve_.stops[stop_].refused = true;
  curve_.all_visits -= rounds - round_;
  go_on();
}

void TuningSweep::add(const UpdateCost& cost) {
  assert(runs());
  if (++frames_ <= settling_frames) return;
  measured_[stop_].push_back(cost);
  if (frames_ < settling_frames + measured_frames) return;
  curve_.stops[stop_].cost = median_of(measured_[stop_]);
  curve_.stops[stop_].known = true;
  ++curve_.visits;
  go_on();
}

// Goes to the next stop that was not refused; after the last stop the next round begins.
void TuningSweep::go_on() {
  frames_ = 0;
  do {
    if (++stop_ < curve_.stops.size()) continue;
    stop_ = 0;
    ++round_;
  } while (round_ < rounds && curve_.stops[stop_].refused);
  curve_.runs = round_ < rounds;
}

}  // namespace throng::app
