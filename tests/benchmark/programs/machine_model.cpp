#include "tests/benchmark/programs/machine_model.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "app/files/json_file.h"
#include "engine/base/json/json_object.h"

namespace throng::app {
namespace {

using Kind = anim::TraceSpan::Kind;

anim::CopyCounts copies_of(const anim::TraceSpan& span) { return {span.bytes_in, span.bytes_out, span.transfers}; }

}  // namespace

Result<Machine> read_machine(const std::filesystem::path& file) {
  const JsonFile json_file(file, {.unread = "name a machine"});
  const auto json = json_file.read();
  if (!json) return json.error();
  std::optional<std::string> complaint;
  const JsonObject reader("", *json,
                          {"name", "local_store_kib", "pus", "dma_latency_ns", "dma_gigabytes_per_second",
                           "dma_transfers_in_flight", "compute_times", "compute_ns_per_bone", "notes"},
                          complaint);
  Machine machine;
  reader.text("name", machine.name);
  reader.whole("local_store_kib", machine.local_store_kib, 1, 65536);
  reader.whole("pus", machine.pus, 1, 256);
  reader.number("dma_latency_ns", machine.dma_latency_ns, 0, 1e6);
  reader.number("dma_gigabytes_per_second", machine.dma_gigabytes_per_second, 1e-3, 1e4);
  reader.whole("dma_transfers_in_flight", machine.dma_transfers_in_flight, 1, 1024);
  reader.number("compute_times", machine.compute_times, 1e-3, 1e6);
  if (reader.has("compute_ns_per_bone")) {
    reader.number("compute_ns_per_bone", machine.compute_ns_per_bone.emplace(), 0, 1e9);
    if (reader.has("compute_times")) {
      reader.complain("\"compute_times\" contradicts compute_ns_per_bone; give one of them");
    }
  }
  reader.text("notes", machine.notes);
  reader.need(
      {"name", "local_store_kib", "pus", "dma_latency_ns", "dma_gigabytes_per_second", "dma_transfers_in_flight"});
  if (complaint) return json_file.wrong(*complaint);
  return machine;
}

double dma_time(const Machine& machine, const anim::CopyCounts& copies) {
  if (copies.transfers == 0) return 0;
  const auto in_flight = static_cast<std::uint64_t>(machine.dma_transfers_in_flight);
  const std::uint64_t batches = (copies.transfers + in_flight - 1) / in_flight;
  const auto bytes = static_cast<double>(copies.bytes_in + copies.bytes_out);
  return static_cast<double>(batches) * machine.dma_latency_ns + bytes / machine.dma_gigabytes_per_second;
}

MachinePrediction predict(const Machine& machine, std::span<const RecordedTask> tasks) {
  MachinePrediction prediction;
  for (const RecordedTask& task : tasks) {
    const double compute = machine.compute_ns_per_bone ? *machine.compute_ns_per_bone * task.bones
                                                       : machine.compute_times * task.compute_ns;
    const double hidden = dma_time(machine, task.while_computing);
    const double exposed = dma_time(machine, task.before) + dma_time(machine, task.after);
    prediction.dma_ns += hidden + exposed;
    prediction.stall_ns += exposed + std::max(0.0, hidden - compute);
    prediction.busy_ns += exposed + std::max(hidden, compute);
  }
  return prediction;
}

std::vector<RecordedTask> recorded_tasks(std::span<const anim::TraceSpan> spans, const anim::UpdateTime& time,
                                         const BesideBlocks& beside) {
  std::vector<RecordedTask> tasks;
  anim::CopyCounts pending;  // of the last fetch
  anim::CopyCounts exposed;  // of fetches before it: the first of a stage
  for (const anim::TraceSpan& span : spans) {
    if (span.kind == Kind::fetch) {
      exposed += pending;
      pending = copies_of(span);
    } else if (span.kind == Kind::compute) {
      tasks.push_back({.compute_ns = (time.ms(span.end) - time.ms(span.begin)) * 1e6,
                       .while_computing = pending,
                       .before = exposed,
                       .after = {}});
      pending = exposed = {};
    } else if (span.kind == Kind::write_back && !tasks.empty()) {
      tasks.back().after += copies_of(span);
    }
  }
  const auto count = static_cast<double>(std::max<std::size_t>(tasks.size(), 1));
  const auto share = [&](std::uint64_t whole) {
    return static_cast<std::uint64_t>(std::llround(static_cast<double>(whole) / count));
  };
  for (RecordedTask& task : tasks) {
    task.bones = beside.bones / count;
    task.while_computing +=
        {share(beside.stream_bytes), share(beside.palette_bytes), share(beside.stream_reads + beside.palettes)};
  }
  return tasks;
}

}  // namespace throng::app
