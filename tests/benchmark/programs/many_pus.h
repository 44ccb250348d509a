#pragma once

#include <string>
#include <vector>

namespace throng::app {

/// A task as one PU takes it on its own.
struct SimulatedTask {
  double ns = 0;     ///< computing and copying
  double bytes = 0;  ///< what passes main memory meanwhile
};

/// Tasks that PUs share out. All wait at the end of a round.
struct SimulatedRound {
  std::vector<SimulatedTask> tasks;
  std::vector<int> firsts;  ///< [PU] the first task of its own share; last, the number of tasks
  int most_at_once = 1;     ///< the tasks that a PU takes together while many are left

  double work_ns() const;
};

/// A frame that was recorded on one thread: what PU 0 does alone, and rounds that all PUs share.
struct SimulatedFrame {
  double serial_ns = 0;
  std::vector<SimulatedRound> rounds;

  double work_ns() const;
};

/// Returns the frame of a crowd that is so many times as large: every PU has its tasks as many times.
SimulatedFrame repeated(const SimulatedFrame& frame, int times);

/// A machine with caches. A rate in gigabytes a second is one in bytes a nanosecond.
struct ManyPus {
  std::string name;
  int pus = 1;
  int sockets = 1;                         ///< PUs lie on them one after the other, as many on each
  double memory_gigabytes_per_second = 0;  ///< of one socket, shared by its PUs; 0: no limit
  double link_gigabytes_per_second = 0;    ///< from one socket to another; 0: no limit
  double wake_ns = 0;                      ///< from the start of a round to the first task of another PU
  double line_ns = 0;                      ///< until a cache line that another PU wrote is here
  bool on_first_socket = false;            ///< all data lie in the memory of the first socket, not each PU's in its own
};

/// The time of a frame, and where it goes. The parts add up to the whole.
struct FrameTime {
  double serial_ns = 0;  ///< PU 0 alone
  double work_ns = 0;    ///< all tasks, evenly over the PUs
  double queue_ns = 0;   ///< waking, taking tasks, and waiting for who has more
  double memory_ns = 0;  ///< what tasks take longer because PUs share memory

  double ns() const { return serial_ns + work_ns + queue_ns + memory_ns; }
};

/// Predicts a frame that was recorded with shares for as many PUs as `machine` has. PUs take tasks as TaskQueue hands
/// them out: each from its own share, then from those of others. Where the tasks that run ask for more than their
/// memory or their link gives, all of them slow down alike: a task is as slow as its bytes, or as its operations.
FrameTime simulate(const ManyPus& machine, const SimulatedFrame& frame);

}  // namespace throng::app
