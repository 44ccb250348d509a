#pragma once

#include <string>

#include "engine/anim/import/import.h"

namespace throng::anim {
struct Kernels;
}  // namespace throng::anim

namespace throng::app {

/// The options of `throng lod`.
struct LodOptions {
  std::string model;                       ///< empty: the built-in character
  const anim::Kernels* kernels = nullptr;  ///< of one SIMD target; null: the best
  int pixels = 200;                        ///< height on screen at which errors are given in pixels
  std::string json, plot;                  ///< empty: not asked for; json may be `-`, standard output
  std::string export_file;                 ///< for another engine
  bool remove_parts = false;               ///< remove remains of killed runs beside the files to write
  std::string data;                        ///< folder of the built-in character
  import::ImportOptions reading{};
};

/// Runs `throng lod`: measures the cost of each bone level of a character in time and in pixels. Returns the exit
/// status.
int run_lod(const LodOptions& options);

}  // namespace throng::app
