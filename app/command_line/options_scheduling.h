#pragma once

#include "app/command_line/option_reader.h"
#include "app/settings/settings.h"

namespace throng::app {

/// What a PU works in, the same for the demo's Tuning and for BenchOptions.
template <typename Options>
void declare_local_store(OptionReader& reader, Options& options) {
  reader.value("--local-store", "auto|KIB", "A PU's local store: what a character needs, or just so much (auto)",
               auto_or_kibibytes(options.local_store_kib));
  reader.value("--tile", "N", "Characters a tile: 1, 2, 4, 8 or 16 (what fits)",
               choice<int>(options.tile, {{"1", 1}, {"2", 2}, {"4", 4}, {"8", 8}, {"16", 16}}));
  reader.value("--double-buffer", "MODE", "off, inline or interleaved (interleaved)",
               choice<DoubleBuffer>(options.double_buffer, {{"off", DoubleBuffer::off},
                                                            {"inline", DoubleBuffer::inline_copy},
                                                            {"interleaved", DoubleBuffer::interleaved}}));
}

template <typename Options>
void declare_palette(OptionReader& reader, Options& options) {
  reader.value("--palette", "FORMAT", "float, 48 bytes a bone, or packed, 16, where a skeleton is rigid (float)",
               choice<Palette>(options.palette, {{"float", Palette::floats}, {"packed", Palette::packed}}));
}

inline std::vector<std::pair<std::string, Schedule>> schedule_names() {
  return {{"fused", Schedule::fused}, {"levels", Schedule::levels}};
}
inline std::vector<std::pair<std::string, Stream>> stream_names() {
  return {{"sampled", Stream::sampled}, {"keyframe", Stream::keyframe}};
}

}  // namespace throng::app
