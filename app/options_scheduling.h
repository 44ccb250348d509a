#pragma once

#include "app/option_reader.h"
#include "app/settings.h"

namespace throng::app {

/// The options that say how poses are computed, the same for the demo's Tuning and for BenchOptions.
template <typename Options>
void declare_scheduling(OptionReader& reader, Options& options) {
  reader.heading("Scheduling");
  reader.value("--pus", "N", "PUs, the calling thread among them, 1 to 256 (all cores)",
               whole_number(options.pus, 1, 256));
  reader.value("--local-store", "auto|KIB", "A PU's local store: what a character needs, or just so much (auto)",
               auto_or_kibibytes(options.local_store_kib));
  reader.value("--schedule", "NAME", "fused or levels (fused)",
               choice<Schedule>(options.schedule, {{"fused", Schedule::fused}, {"levels", Schedule::levels}}));
  reader.value("--tile", "N", "Characters a tile: 1, 2, 4, 8 or 16 (what fits)",
               choice<int>(options.tile, {{"1", 1}, {"2", 2}, {"4", 4}, {"8", 8}, {"16", 16}}));
  reader.value("--double-buffer", "MODE", "off, inline or interleaved (interleaved)",
               choice<DoubleBuffer>(options.double_buffer, {{"off", DoubleBuffer::off},
                                                            {"inline", DoubleBuffer::inline_copy},
                                                            {"interleaved", DoubleBuffer::interleaved}}));
  reader.value("--stream", "NAME", "sampled or keyframe (sampled)",
               choice<Stream>(options.stream, {{"sampled", Stream::sampled}, {"keyframe", Stream::keyframe}}));
}

}  // namespace throng::app
