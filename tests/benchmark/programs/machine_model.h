#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/anim/run/store/trace.h"
#include "engine/base/result.h"

namespace throng::app {

/// A machine whose PUs see main memory through a DMA controller alone, as the paper's does (1.1, footnote 7).
struct Machine {
  std::string name;
  int local_store_kib = 0;
  int pus = 1;
  double dma_latency_ns = 0;                                 ///< until the first byte of a transfer
  double dma_gigabytes_per_second = 1;                       ///< the rate of one PU
  int dma_transfers_in_flight = 1;                           ///< the number of transfers whose latencies overlap
  std::optional<double> compute_ns_per_bone = std::nullopt;  ///< nothing: compute_times says how fast the PUs are
  double compute_times = 1;  ///< the factor by which computing takes longer than on the recorded PU
  std::string notes = {};
};

/// Reads the JSON object of tests/benchmark/README.md. The error names the file, the key and what is allowed there.
Result<Machine> read_machine(const std::filesystem::path& file);

/// One task as it was recorded. With double buffering, the results of the task before it and the data of the task after
/// it are copied while it is computed.
struct RecordedTask {
  double compute_ns = 0;
  double bones = 0;
  anim::CopyCounts while_computing;
  anim::CopyCounts before, after;  ///< copies that nothing hides, of the first task of a stage and of the last
};

struct MachinePrediction {
  double busy_ns = 0;   ///< the time of one PU for all tasks
  double stall_ns = 0;  ///< the part of this time that waits for copies
  double dma_ns = 0;    ///< the time that copies take, hidden or not
  double overlap() const { return dma_ns > 0 ? 1.0 - stall_ns / dma_ns : 1.0; }
};

/// Returns the nanoseconds that a batch of transfers takes: latencies as far as they do not overlap, then bytes.
double dma_time(const Machine& machine, const anim::CopyCounts& copies);

/// Predicts the time of task after task with double buffering: the longer of computing and copying, plus the copies
/// that nothing hides.
MachinePrediction predict(const Machine& machine, std::span<const RecordedTask> tasks);

/// The work of a trace's updates beside blocks: the bones that they evaluated, the rows of streams that they read, and
/// the palettes that they wrote.
struct BesideBlocks {
  double bones = 0;
  std::uint64_t stream_bytes = 0, stream_reads = 0;
  std::uint64_t palette_bytes = 0, palettes = 0;
};
/// Returns the tasks of a trace taken with DoubleBuffering::inline_copy on one PU. The work in `beside` is shared out
/// over them evenly.
std::vector<RecordedTask> recorded_tasks(std::span<const anim::TraceSpan> spans, const anim::UpdateTime& time,
                                         const BesideBlocks& beside);

}  // namespace throng::app
