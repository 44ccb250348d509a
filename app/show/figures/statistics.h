#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/show/figures/lod_sums.h"
#include "app/show/figures/sample_counts.h"
#include "engine/base/result.h"

namespace throng::app {

class Stage;

/// Names the context that drew the frames, as `--stats` has it.
struct DrawnBy {
  std::string context = "none";
  std::string gl_version, gl_renderer;  ///< empty without GL
};

/// The milliseconds of the parts of a start, in their order. The first update and the first picture follow.
struct StartTimes {
  double characters_ms = 0;  ///< files are imported and baked, or taken out of packs
  double device_ms = 0;      ///< the device is opened, shaders are compiled, scenery is loaded
  double spawn_ms = 0;       ///< the crowd is made: places, agents, clips, blocks
  double meshes_ms = 0;      ///< surfaces are simplified and copied to the device
};

/// Collects a run's figures and writes them as one flat JSON object (app/commands/command_line/README.md). It does not
/// grow with the run.
class Statistics {
 public:
  StartTimes start;  ///< open_show() writes it

  void add_update(double milliseconds);
  void add_drawn_frame(double milliseconds);
  /// Takes the time of laying out the overlay.
  void add_overlay(double milliseconds) { overlay_ms_.add(milliseconds); }
  void set_draw(std::uint32_t draw_calls, std::uint64_t triangles);
  /// Takes the figures of an update; call it after each.
  void add_report(const Stage& stage);

  Status write(const std::string& path, const Stage& stage, const DrawnBy& drawn_by) const;

 private:
  SampleCounts update_ms_, frame_ms_, overlay_ms_;
  std::optional<double> first_update_ms_, first_picture_ms_;
  std::uint32_t draw_calls_ = 0;
  std::uint64_t triangles_ = 0;
  std::uint64_t frames_ = 0;
  std::uint64_t palette_bytes_ = 0, dma_in_ = 0, dma_out_ = 0, dma_transfers_ = 0, stream_bytes_ = 0;
  std::uint64_t agents_updated_ = 0, bones_evaluated_ = 0;
  std::uint64_t agents_demoted_ = 0;
  LodSums::LimitCount triangle_budget_;
  LodSums lod_;
};

/// Returns the median of `values`; 0 where there are none.
double median(std::vector<double> values);

}  // namespace throng::app
