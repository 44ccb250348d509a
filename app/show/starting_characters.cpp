#include "app/show/starting_characters.h"

#include <algorithm>
#include <utility>

#include "app/character/built_in.h"
#include "app/character/model_placement.h"
#include "app/character/role_table.h"
#include "app/character/skin_choice.h"
#include "app/files/exit_status.h"
#include "app/show/opened_crowd.h"
#include "app/show/request/crowd_file.h"

namespace throng::app {
namespace {

std::vector<CastEntry> entries_of(const DemoOptions& options) {
  std::vector<CastEntry> entries = options.models.empty() ? options.cast : cast_of(options.models);
  for (CastEntry& entry : entries) entry.file = with_skin(entry.file, options.skin);
  return entries;
}

bool says_characters(const DemoOptions& options) {
  return options.crowd != nullptr && !options.crowd->characters.empty();
}

Result<LoadedCast> load_said(const DemoOptions& options, const LoadOptions& how) {
  auto cast = load_crowd(options.crowd->characters, options.data, how);
  if (!cast) return Error{(options.crowd_file.empty() ? "--crowd" : options.crowd_file) + ": " + cast.error().message};
  return cast;
}

Result<LoadedCast> load(const DemoOptions& options, const LoadOptions& how) {
  if (says_characters(options)) return load_said(options, how);
  const std::vector<CastEntry> entries = entries_of(options);
  if (!entries.empty()) return load_cast(entries, how);
  auto character = load_built_in(options.data, how);
  if (!character) return character.error();
  LoadedCast cast;
  cast.characters.push_back(std::move(*character));
  return cast;
}

// The command line chooses for every character that has such a clip.
bool take_chosen_role(const RoleChoice& choice, std::span<CharacterSource> characters, StartError& error) {
  std::string refusal;
  bool taken = false;
  for (CharacterSource& character : characters) {
    RoleClips clips = character.roles.clips;
    const auto chosen = choose_clips({&choice, 1}, character.clip_names, clips);
    if (chosen) assign_roles(character, clips);
    if (!chosen && refusal.empty()) refusal = chosen.error().message;
    taken |= chosen.has_value();
  }
  return taken || fail(error, exit_usage, "--clips " + refusal);
}

bool choose_roles(const DemoOptions& options, std::span<CharacterSource> characters, StartError& error) {
  const auto kept = [&](CharacterSource& character) {
    const Status taken = take_kept_roles(character);
    return taken || fail(error, exit_job_failed, taken.error().message);
  };
  const auto chosen = [&](const RoleChoice& choice) { return take_chosen_role(choice, characters, error); };
  const bool says_all = says_characters(options);
  return (says_all || std::ranges::all_of(characters, kept)) && std::ranges::all_of(options.clips, chosen);
}

// A replay, a preset of a crowd file and a window may turn the wardrobe on later.
bool may_dress(const DemoOptions& options) {
  return options.tuning.wardrobe || options.context == ContextKind::window || !options.replay.empty() ||
         options.crowd != nullptr;
}

}  // namespace

LoadOptions load_options(const DemoOptions& options) {
  return {.import = options.reading,
          .placement = options.placement,
          .placements = options.placements,
          .clips_from = options.clips_from,
          .wardrobe = may_dress(options)};
}

bool fail(StartError& error, int status, std::string message) {
  error = {{std::move(message)}, status};
  return false;
}

std::optional<LoadedCast> load_starting_characters(const DemoOptions& options, StartError& error,
                                                   const LoadProgress& progress) {
  LoadOptions how = load_options(options);
  how.progress = progress;
  auto cast = load(options, how);
  if (!cast) return fail(error, exit_job_failed, cast.error().message), std::nullopt;
  if (const Status known = check_placed_models(options.placements, cast->characters); !known) {
    return fail(error, exit_usage, known.error().message), std::nullopt;
  }
  if (!choose_roles(options, cast->characters, error)) return {};
  for (CharacterSource& character : cast->characters) {
    if (options.cast_rules.empty()) continue;
    character.cast_rules = options.cast_rules;
    character.rules_are_chosen = true;
  }
  return std::move(*cast);
}

}  // namespace throng::app
