#pragma once

#include <string>
#include <vector>

#include "app/settings/settings.h"
#include "engine/anim/import/import.h"

namespace throng::app {

/// The options of `throng bench`. It runs without LOD and crowd logic, and measures every combination of the lists.
/// With `draws`, it measures what a frame of each number of agents costs.
struct BenchOptions {
  std::string model;              ///< empty: a branching skeleton of `bones` bones with `clips` different clips
  std::vector<int> agents{1000};  ///< each 1 to 100,000
  std::vector<int> bones{62};     ///< each 1 to anim::max_bones
  std::vector<int> clips{2};      ///< each 1 to 256
  std::vector<int> pus{0};        ///< 0: all cores
  std::vector<anim::Schedule> schedules{anim::Schedule::fused};
  std::vector<anim::StreamKind> streams{anim::StreamKind::sampled};
  Tuning tuning;  ///< its `system` has values of all combinations: local store, tile, double buffering, palettes
  const anim::Kernels* kernels = nullptr;  ///< of one SIMD target; null: the best
  int frames = 60;
  bool draws = false;         ///< whole frames are measured, crowd logic, level of detail and drawing included
  DemoOptions shown;          ///< the show of these frames, its camera and device
  float seconds = 20;         ///< that each number of agents may take, above 0
  std::string data;           ///< folder of shaders and assets; empty: the usual places
  std::string json;           ///< a file, "-" for standard output, empty: lines for a person
  std::string plot;           ///< an SVG file; empty: none
  std::string trace;          ///< empty: none
  bool remove_parts = false;  ///< remove remains of killed runs beside the files to write
  import::ImportOptions reading{};
};

/// One combination of the lists.
struct BenchCase {
  int agents = 1000, bones = 62, clips = 2, pus = 0;
  anim::Schedule schedule = anim::Schedule::fused;
  anim::StreamKind stream = anim::StreamKind::sampled;
};

/// Measures poses per second; every figure is taken in interleaved rounds of the same run. Returns the exit status.
int run_bench(const BenchOptions& options);

}  // namespace throng::app
