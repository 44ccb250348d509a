#include "app/commands/bench/machine_model.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/files/json_file.h"

namespace throng::app {
namespace {

using Kind = anim::TraceSpan::Kind;

/// Reads keys one after the other and keeps the first complaint.
class MachineReader {
 public:
  MachineReader(const JsonFile& file, const Json& json) : file_(&file), json_(&json) {}

  void number(const char* key, double least, double most, double& target, bool needed = true) {
    if (!json_->contains(key)) {
      if (needed) complain(key, "is missing: " + range(least, most));
      return;
    }
    const Json& value = (*json_)[key];
    const double found = value.is_number() ? value.get<double>() : std::nan("");
    const bool fits = found >= least && found <= most;
    if (!fits) complain(key, "must be " + range(least, most));
    if (fits) target = found;
  }
  void whole(const char* key, int least, int most, int& target) {
    double value = target;
    number(key, least, most, value);
    target = static_cast<int>(value);
    if (static_cast<double>(target) != value) complain(key, "must be a whole number");
  }
  void text(const char* key, std::string& target, bool needed) {
    if (!json_->contains(key)) {
      if (needed) complain(key, "is missing: a text");
      return;
    }
    if (!(*json_)[key].is<std::string>()) complain(key, "must be a text");
    target = json_->value(key, target);
  }
  void complain(const std::string& key, const std::string& what) {
    if (complaint_) complaint_ = file_->wrong("\"" + key + "\" " + what);
  }
  /// The first complaint; an unknown key is one.
  anim::Status complaint(std::initializer_list<std::string_view> known) {
    if (const Json::Member* const other = json_->member_beside(known)) complain(other->key, "is no key of a machine");
    return complaint_;
  }

 private:
  static std::string range(double least, double most) {
    char text[96];
    std::snprintf(text, sizeof(text), "a number, %g to %g", least, most);
    return text;
  }

  const JsonFile* file_;
  const Json* json_;
  anim::Status complaint_ = anim::Done{};
};

anim::CopyCounts copies_of(const anim::TraceSpan& span) { return {span.bytes_in, span.bytes_out, span.transfers}; }

}  // namespace

anim::Result<Machine> read_machine(const std::filesystem::path& file) {
  const JsonFile json_file(file, {.unread = "; --machine takes ps2, spe or a file"});
  const auto json = json_file.read();
  if (!json) return json.error();
  if (!json->is_object()) return json_file.wrong("not a JSON object that describes a machine");
  Machine machine;
  MachineReader reader(json_file, *json);
  reader.text("name", machine.name, true);
  reader.whole("local_store_kib", 1, 65536, machine.local_store_kib);
  reader.whole("pus", 1, 256, machine.pus);
  reader.number("dma_latency_ns", 0, 1e6, machine.dma_latency_ns);
  reader.number("dma_gigabytes_per_second", 1e-3, 1e4, machine.dma_gigabytes_per_second);
  reader.whole("dma_transfers_in_flight", 1, 1024, machine.dma_transfers_in_flight);
  reader.number("compute_times", 1e-3, 1e6, machine.compute_times, false);
  if (json->contains("compute_ns_per_bone")) {
    reader.number("compute_ns_per_bone", 0, 1e9, machine.compute_ns_per_bone.emplace());
    if (json->contains("compute_times")) {
      reader.complain("compute_times", "contradicts compute_ns_per_bone; give one of them");
    }
  }
  reader.text("notes", machine.notes, false);
  const anim::Status complaint =
      reader.complaint({"name", "local_store_kib", "pus", "dma_latency_ns", "dma_gigabytes_per_second",
                        "dma_transfers_in_flight", "compute_times", "compute_ns_per_bone", "notes"});
  if (!complaint) return complaint.error();
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
