#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/anim/import/import.h"
#include "engine/anim/survey/placement_guess.h"

namespace throng::app {

/// Says the size and place of one model among several. An unset member is as for all models.
struct ModelPlacement {
  std::string model;  ///< the name of its file, with or without its ending, or of its character
  std::optional<double> scale = std::nullopt;
  std::optional<anim::UpAxis> up = std::nullopt;
  std::optional<anim::GroundRule> ground = std::nullopt;

  friend bool operator==(const ModelPlacement&, const ModelPlacement&) = default;
};

/// Takes the progress of loading: the share that is done, 0 to 1, and what comes now. One thread calls it at a time.
using LoadProgress = std::function<void(double share, const std::string& what)>;
/// Work that takes long. It calls the progress that it is given as often as it may end.
using LongWork = std::function<void(const LoadProgress& progress)>;

/// Says how the files of characters are read.
struct LoadOptions {
  import::ImportOptions import{};
  anim::PlacementChoice placement{};         ///< size and place; what it leaves open is guessed
  std::vector<ModelPlacement> placements{};  ///< of single models, over the one of all
  std::vector<std::string> clips_from{};     ///< files whose clips every character plays too
  bool wardrobe = false;                     ///< the built-in character gets its parts
  LoadProgress progress{};                   ///< null: progress is not reported
};

}  // namespace throng::app
