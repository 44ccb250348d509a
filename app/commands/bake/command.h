#pragma once

#include <string>
#include <vector>

#include "engine/anim/import/import.h"
#include "engine/anim/survey/placement_guess.h"

namespace throng::app {

/// The options of `throng bake`.
struct BakeOptions {
  std::vector<std::string> models;
  bool built_in = false;                ///< bakes the built-in character with its wardrobe, and no models
  std::string data;                     ///< folder of assets; empty: the usual ones
  std::string pack;                     ///< the file to write
  bool keep_keys = false;               ///< packs the keys of the models too
  bool remove_parts = false;            ///< remove remains of killed runs beside the file to write
  std::vector<std::string> clips_from;  ///< files whose clips every model plays too
  anim::PlacementChoice placement;
  import::ImportOptions reading{};
};

/// Bakes all characters of the models into one pack, and lists its contents. Returns the exit status. The pack is
/// written whole or not at all.
int run_bake(const BakeOptions& options);

}  // namespace throng::app
