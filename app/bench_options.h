#pragma once

#include <string>

#include "app/settings.h"

namespace throng::app {

/// What `throng bench` was asked for. LOD and crowd logic are always off there.
struct BenchOptions {
  std::string model;  ///< empty: a branching skeleton of `bones` bones with `clips` different clips
  int agents = 1000;  ///< 1 to 100,000
  int bones = 62;     ///< 1 to anim::max_bones
  int clips = 2;      ///< 1 to 256
  int pus = 0;        ///< 0: all cores
  Schedule schedule = Schedule::fused;
  Stream stream = Stream::sampled;
  int local_store_kib = 0;  ///< 0: auto
  int tile = 0;             ///< characters a tile, 0: what fits; 1, 2, 4, 8, 16
  DoubleBuffer double_buffer = DoubleBuffer::interleaved;
  int frames = 60;
  std::string json;  ///< a file, "-" for standard output, empty: lines for a person
};

}  // namespace throng::app
