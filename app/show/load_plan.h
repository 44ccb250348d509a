#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/character/cast_files.h"
#include "app/show/request/request.h"
#include "engine/tracks/read.h"

namespace throng::app {

/// The characters that one request brings.
struct CastToLoad {
  std::vector<std::string> files = {};           ///< that came together; or else
  std::vector<ChosenCharacter> characters = {};  ///< as a person chose them
};

/// Returns the characters that a request brings from files; nothing where it brings none. `people` are those of the
/// crowd that it is made to.
std::optional<CastToLoad> cast_to_load(const CrowdRequest& request, std::span<const CharacterSource> people);

/// Loads the characters of a request. `data` is what --data says, for the built-in character. Errors: a file cannot be
/// used, or there are too many characters.
Result<LoadedCast> load(const CastToLoad& cast, const LoadOptions& options, const std::string& data);

/// Builds the surfaces of characters that are to be drawn.
void build_surfaces(std::vector<CharacterSource>& characters, const LoadProgress& progress);

/// All that the next requests of a person bring from files. It shares nothing with a show, so any thread may load it.
struct LoadPlan {
  std::vector<CastToLoad> casts = {};  ///< in the order of their requests
  std::string tracks = {};             ///< a recorded crowd; empty: none
  TrackReading reading = {};           ///< how it is read
  LoadOptions options = {};
  std::string data = {};
  bool is_drawn = false;  ///< surfaces are built, too

  bool is_empty() const { return casts.empty() && tracks.empty(); }
  /// Returns the file, or the character, that it begins with.
  std::string name() const;
};

/// What came of a plan.
struct Loaded {
  std::deque<LoadedCast> casts;
  std::shared_ptr<const Trajectories> tracks;  ///< null: the plan has none
};

/// Loads all of a plan. Errors: a file cannot be used. An exception of `progress` ends it.
Result<Loaded> load(LoadPlan plan, const LoadProgress& progress);

}  // namespace throng::app
