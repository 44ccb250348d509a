#include "app/show/load_plan.h"

#include <filesystem>
#include <utility>

#include "app/character/built_in.h"
#include "app/show/opened_crowd.h"
#include "engine/tracks/trajectories.h"

namespace throng::app {
namespace {

constexpr double share_of_reading = 0.6;  // of the time that a cast takes; the rest builds its surfaces

/// Says how far one of several parts of equal length is, as a share of them all.
LoadProgress part_of(const LoadProgress& progress, std::size_t part, std::size_t parts, double from, double to) {
  const auto first = static_cast<double>(part), all = static_cast<double>(parts);
  return [=, &progress](double share, const std::string& what) {
    progress((first + from + (to - from) * share) / all, what);
  };
}

}  // namespace

void build_surfaces(std::vector<CharacterSource>& characters, const LoadProgress& progress) {
  for (std::size_t i = 0; i < characters.size(); ++i) {
    const std::string name = std::filesystem::path(characters[i].name).filename().string();
    progress(static_cast<double>(i) / static_cast<double>(characters.size()), name + ", its meshes");
    build_surface(characters[i]);
  }
}

std::optional<CastToLoad> cast_to_load(const CrowdRequest& request, std::span<const CharacterSource> people) {
  if (const auto* const models = std::get_if<LoadModels>(&request)) return CastToLoad{.files = models->files};
  if (const auto* const cast = std::get_if<SetCast>(&request)) return CastToLoad{.characters = cast->characters};
  const auto* const placement = std::get_if<SetPlacement>(&request);
  if (placement == nullptr || placement->character >= people.size()) return {};
  CastToLoad placed{.characters = {exactly(people[placement->character])}};
  placed.characters.front().placement = placement->choice;
  return placed;
}

Result<LoadedCast> load(const CastToLoad& cast, const LoadOptions& options, const std::string& data) {
  const std::size_t count = cast.characters.size();
  if (cast.files.empty() && (count == 0 || count > most_models)) {
    return Error{"a crowd has 1 to " + std::to_string(most_models) + " characters, not " + std::to_string(count)};
  }
  if (cast.files.empty()) return load_crowd(cast.characters, data, options);
  auto loaded = load_dropped(cast.files, options);
  if (!loaded) return loaded;
  for (CharacterSource& character : loaded->characters) {
    if (const Status kept = take_kept_roles(character); !kept) return kept.error();
  }
  return loaded;
}

std::string LoadPlan::name() const {
  if (casts.empty()) return tracks;
  if (!casts.front().files.empty()) return casts.front().files.front();
  const std::string& file = casts.front().characters.empty() ? std::string() : casts.front().characters.front().file;
  return file.empty() ? built_in_name : file;
}

Result<Loaded> load(LoadPlan plan, const LoadProgress& progress) {
  const std::size_t parts = plan.casts.size() + (plan.tracks.empty() ? 0 : 1);
  Loaded loaded;
  for (std::size_t i = 0; i < plan.casts.size(); ++i) {
    plan.options.progress = part_of(progress, i, parts, 0.0, share_of_reading);
    auto cast = load(plan.casts[i], plan.options, plan.data);
    if (!cast) return cast.error();
    if (plan.is_drawn) build_surfaces(cast->characters, part_of(progress, i, parts, share_of_reading, 1.0));
    loaded.casts.push_back(std::move(*cast));
  }
  if (plan.tracks.empty()) return loaded;
  const LoadProgress of_tracks = part_of(progress, parts - 1, parts, 0.0, 1.0);
  auto read = read_trajectories(plan.tracks, plan.reading, [&](double share) { of_tracks(share, plan.tracks); });
  if (!read) return read.error();
  loaded.tracks = std::make_shared<const Trajectories>(std::move(*read));
  return loaded;
}

}  // namespace throng::app
