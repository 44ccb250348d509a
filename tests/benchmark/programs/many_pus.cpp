#include "tests/benchmark/programs/many_pus.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace throng::app {
namespace {

/// One round, event by event: between two events each PU does one thing, at one speed.
class Round {
 public:
  Round(const ManyPus& machine, const SimulatedRound& round)
      : machine_(machine), round_(round), next_(round.firsts.begin(), round.firsts.end() - 1), pus_(next_.size()) {
    for (std::size_t pu = 0; pu < pus_.size(); ++pu) {
      pus_[pu].left_ns = pu == 0 ? 0 : machine.wake_ns + static_cast<double>(pu) * machine.line_ns;
    }
  }

  double run() {
    double now = 0;
    std::size_t working = pus_.size();
    while (working > 0) {
      const double step = until_next_event();
      now += step;
      for (std::size_t pu = 0; pu < pus_.size(); ++pu) {
        Pu& each = pus_[pu];
        if (each.is_done) continue;
        each.left_ns -= step * speed_of(pu);
        if (each.left_ns > nearly_nothing) continue;
        begin_next(pu);
        if (each.is_done) --working;
      }
    }
    return now;
  }

 private:
  static constexpr double nearly_nothing = 1e-6;

  struct Pu {
    double left_ns = 0;       // of what it does, at full speed
    double bytes_per_ns = 0;  // that it asks memory for meanwhile
    int first = 0, end = 0;   // the tasks that it has taken
    bool scans = false, is_done = false;
  };

  std::size_t socket_of(std::size_t pu) const {
    return pu * static_cast<std::size_t>(machine_.sockets) / static_cast<std::size_t>(machine_.pus);
  }
  static double share(double offered, double asked) { return offered > 0 && asked > offered ? offered / asked : 1.0; }

  /// Finds how fast the PUs of each socket are while they do what they do now.
  void find_speeds() {
    std::vector<double> asked(static_cast<std::size_t>(machine_.sockets), 0.0);
    double all = 0;
    for (std::size_t pu = 0; pu < pus_.size(); ++pu) {
      if (pus_[pu].is_done) continue;
      asked[socket_of(pu)] += pus_[pu].bytes_per_ns;
      all += pus_[pu].bytes_per_ns;
    }
    speeds_.assign(asked.size(), 1.0);
    for (std::size_t socket = 0; socket < asked.size(); ++socket) {
      speeds_[socket] = share(machine_.memory_gigabytes_per_second, machine_.on_first_socket ? all : asked[socket]);
      if (!machine_.on_first_socket || socket == 0) continue;
      speeds_[socket] = std::min(speeds_[socket], share(machine_.link_gigabytes_per_second, asked[socket]));
    }
  }
  double speed_of(std::size_t pu) const { return pus_[pu].bytes_per_ns > 0 ? speeds_[socket_of(pu)] : 1.0; }

  double until_next_event() {
    find_speeds();
    double least = std::numeric_limits<double>::max();
    for (std::size_t pu = 0; pu < pus_.size(); ++pu) {
      if (!pus_[pu].is_done) least = std::min(least, pus_[pu].left_ns / speed_of(pu));
    }
    return std::max(least, 0.0);
  }

  void begin_next(std::size_t pu) {
    Pu& each = pus_[pu];
    each.bytes_per_ns = 0;
    if (each.scans) {
      each.is_done = true;
    } else if (each.first < each.end) {
      const SimulatedTask& task = round_.tasks[static_cast<std::size_t>(each.first++)];
      each.left_ns = task.ns;
      each.bytes_per_ns = task.ns > 0 ? task.bytes / task.ns : 0;
    } else {
      each.left_ns = take_some(pu) * machine_.line_ns;
    }
  }

  /// Takes tasks as TaskQueue does. Returns how many lines of others it read for that.
  double take_some(std::size_t pu) {
    Pu& each = pus_[pu];
    const std::size_t count = pus_.size();
    for (std::size_t asked = 0; asked < count; ++asked) {
      const std::size_t of = (pu + asked) % count;
      const int left = round_.firsts[of + 1] - next_[of];
      if (left <= 0) continue;
      const int some = std::clamp(left / (2 * static_cast<int>(count)), 1, round_.most_at_once);
      each.first = next_[of];
      each.end = next_[of] += some;
      return static_cast<double>(asked);
    }
    each.scans = true;
    return static_cast<double>(count - 1);
  }

  const ManyPus& machine_;
  const SimulatedRound& round_;
  std::vector<int> next_;  // [share] the next task that nobody has taken
  std::vector<Pu> pus_;
  std::vector<double> speeds_;  // [socket]
};

double rounds_ns(const ManyPus& machine, const SimulatedFrame& frame) {
  double sum = 0;
  for (const SimulatedRound& round : frame.rounds) sum += Round(machine, round).run();
  return sum;
}

}  // namespace

double SimulatedRound::work_ns() const {
  double sum = 0;
  for (const SimulatedTask& task : tasks) sum += task.ns;
  return sum;
}

double SimulatedFrame::work_ns() const {
  double sum = 0;
  for (const SimulatedRound& round : rounds) sum += round.work_ns();
  return sum;
}

SimulatedFrame repeated(const SimulatedFrame& frame, int times) {
  SimulatedFrame result{.serial_ns = frame.serial_ns * times, .rounds = {}};
  for (const SimulatedRound& round : frame.rounds) {
    SimulatedRound& more = result.rounds.emplace_back();
    more.most_at_once = round.most_at_once;
    for (std::size_t pu = 0; pu + 1 < round.firsts.size(); ++pu) {
      more.firsts.push_back(round.firsts[pu] * times);
      for (int time = 0; time < times; ++time) {
        more.tasks.insert(more.tasks.end(), round.tasks.begin() + round.firsts[pu],
                          round.tasks.begin() + round.firsts[pu + 1]);
      }
    }
    more.firsts.push_back(round.firsts.back() * times);
  }
  return result;
}

FrameTime simulate(const ManyPus& machine, const SimulatedFrame& frame) {
  ManyPus without_limits = machine;
  without_limits.memory_gigabytes_per_second = without_limits.link_gigabytes_per_second = 0;
  const double unlimited = rounds_ns(without_limits, frame);
  FrameTime time{.serial_ns = frame.serial_ns, .work_ns = frame.work_ns() / machine.pus};
  time.queue_ns = unlimited - time.work_ns;
  time.memory_ns = rounds_ns(machine, frame) - unlimited;
  return time;
}

}  // namespace throng::app
