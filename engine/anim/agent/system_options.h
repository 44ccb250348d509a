#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "throng/host.h"

#include "engine/anim/bake/stream_kind.h"
#include "engine/anim/kernel/palette/packed_palette.h"
#include "engine/anim/kernel/palette/write_lines.h"
#include "engine/anim/run/program/cost_model.h"
#include "engine/anim/run/store/schedule.h"
#include "engine/base/result.h"

namespace throng::anim {

struct Kernels;

struct SystemOptions {
  int pus = 1;                        ///< 1 to max_pus
  std::size_t local_store_bytes = 0;  ///< size for each PU; 0: automatic (automatic_local_store), grows with the graphs
  int tile = 0;                       ///< characters a tile: 1, 2, 4, 8, 16; 0: as many as fit, up to 32
  Schedule schedule = Schedule::fused;
  /// Runs the PUs: a host's job system, which outlives the system. Null: the system has threads of its own.
  Executor* executor = nullptr;
  DoubleBuffering double_buffering = DoubleBuffering::interleaved;
  StreamKind stream = StreamKind::sampled;
  bool hash = true;             ///< hash every palette that is written
  Tracing trace = Tracing::on;  ///< record what each PU does, for Figures::units() and update_time()
  bool prefetch = false;        ///< players ask for their rows before the first packet is sampled (paper, note 5)
  CostModel cost{};             ///< orders tasks and cuts tiles
  std::optional<StorePolicy> stores{};  ///< the policy for palettes; none: by their size (run/store/store_choice.h)
  /// The bytes of palettes up to which the caches hold them from one update to the next. 0: as the machine's caches
  /// say. A host that has half a second at load time gives measured_cached_bytes().
  std::size_t cached_bytes = 0;
  /// `packed` is for the characters that can be packed (see Characters::palette_format); all others get matrices.
  PaletteFormat palettes = PaletteFormat::matrices;
  const Kernels* kernels = nullptr;  ///< null: the best that this machine runs

  friend bool operator==(const SystemOptions&, const SystemOptions&) = default;
};
inline constexpr int max_pus = 256;
inline constexpr std::uint32_t most_agents = 1U << 20U;
inline constexpr std::size_t most_local_store_bytes = std::size_t{1} << 30U;

/// Checks that every number is in its range. Errors: the first number out of its range.
Status check(const SystemOptions& options);

}  // namespace throng::anim
