#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "engine/anim/api/character_data.h"
#include "engine/anim/api/chosen_rig.h"
#include "engine/anim/asset/closed_loops.h"
#include "engine/anim/asset/placement.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/base/misuse.h"
#include "engine/anim/survey/placement_guess.h"
#include "engine/base/text/plain_text.h"

#if defined(THRONG_HAS_IMPORT)
#include "engine/anim/import/import.h"
#endif
#if defined(THRONG_HAS_PACK)
#include "engine/anim/pack/pack.h"
#endif

namespace throng {
namespace {

/// Names the clips for which `about` says something; nothing if it does for none.
template <typename About>
std::string named_clips(const anim::Character& character, const About& about) {
  std::string named;
  for (const anim::BakedClip& clip : character.clips) {
    const std::optional<std::string> said = about(clip);
    if (said) named += (named.empty() ? "" : ", ") + plain_text(clip.name) + *said;
  }
  return named;
}

std::optional<std::string> walk_in_place(const anim::BakedClip& clip) {
  if (clip.ground_speed() == 0.0 || !clip.root_motion.keys.empty()) return {};
  char speed[48];
  std::snprintf(speed, sizeof speed, " (%.2f m/s)", clip.ground_speed());
  return speed;
}

bool is_open(const anim::BakedClip& clip) { return clip.closing_step > Ticks{} && clip.root_motion.keys.empty(); }

std::optional<std::string> open_loop(const anim::BakedClip& clip) {
  return is_open(clip) ? std::optional(std::string()) : std::nullopt;
}

#if defined(THRONG_HAS_PACK)
Status load_model(const pack::Pack& pack, std::size_t file, std::size_t model, const LoadOptions& options,
                  detail::ChosenRig& rig, LoadedFile& into) {
  Result<pack::BakedModel> baked = pack.baked(file, model);
  if (!baked) return baked.error();
  rig.give_to(baked->character.skeleton);
  if (!rig.empty()) baked->ragdoll.reset();  // it was built of what the names told
  Result<anim::Model> from = pack.model(file, model, *baked);
  if (!from) return from.error();
  detail::add_character(std::move(*from), std::move(baked->ragdoll), std::move(baked->character), options, into);
  return Done{};
}

Result<LoadedFile> load_pack(const std::string& path, const Result<pack::Pack>& pack, const LoadOptions& options) {
  if (!pack) return pack.error();
  LoadedFile loaded;
  detail::ChosenRig rig(options.rig);
  for (std::size_t file = 0; file < pack->file_count(); ++file) {
    for (std::size_t model = 0; model < pack->names(file).size(); ++model) {
      const Status added = load_model(*pack, file, model, options, rig, loaded);
      if (!added) return added.error();
    }
  }
  if (const Status given = rig.outcome(path); !given) return given.error();
  return loaded;
}
#endif

#if defined(THRONG_HAS_IMPORT)
Result<LoadedFile> load_gltf(const std::string& path, const LoadOptions& options, std::span<const FileInMemory> files) {
  Result<anim::ImportedFile> file =
      import::import_file(path, {.strict = options.strict, .memory_limit = options.memory_limit, .files = files});
  if (!file) return file.error();
  anim::face_forward(*file);
  LoadedFile loaded{.characters = {}, .notes = std::move(file->repairs)};
  for (std::string& note : file->notes) loaded.notes.push_back(std::move(note));
  detail::ChosenRig rig(options.rig);
  for (anim::Model& model : file->models) rig.give_to(model.skeleton);
  if (const Status given = rig.outcome(path); !given) return given.error();
  anim::PlacementChoice choice;
  if (options.scale > 0.0) choice.scale = options.scale;
  for (anim::Model& model : file->models) {
    const anim::GuessedPlacement placed = anim::guess_placement(model, choice);
    anim::place_model(model, placed.placement);
    if (!placed.is_plain) loaded.notes.push_back(placed.reasons);
    anim::Character baked = detail::bake(model, options);
    detail::add_character(std::move(model), {}, std::move(baked), options, loaded);
  }
  return loaded;
}
#else
Error no_gltf(const std::string& path) {
  return Error{path + ": this build of the library reads no glTF; bake the file to a pack with `throng bake`"};
}
#endif

}  // namespace

Status detail::check_options(const std::string& name, const LoadOptions& options) {
  if (options.scale >= 0.0 && options.scale < 1e9) return Done{};
  return Error{plain_text(name) + ": LoadOptions::scale is metres a unit, above 0, or 0 for a guess"};
}

anim::Character detail::bake(anim::Model& model, const LoadOptions& options) {
  anim::Character baked = anim::bake_character(model);
  if (!options.close_loops || std::ranges::none_of(baked.clips, is_open)) return baked;
  for (std::size_t clip = 0; clip < model.clips.size(); ++clip) {
    if (is_open(baked.clips[clip])) anim::close_loop(model.clips[clip], to_seconds(baked.clips[clip].closing_step));
  }
  return anim::bake_character(model);
}

void detail::add_character(anim::Model model, std::optional<anim::RagdollRig> ragdoll, anim::Character baked,
                           const LoadOptions& options, LoadedFile& into) {
  if (const std::string named = named_clips(baked, open_loop); !named.empty()) {
    into.notes.push_back("clips do not loop, because their last key stands one step before their first; " +
                         std::string("LoadOptions::close_loops closes them where a file has keys: ") + named);
  }
  if (options.walk_in_place) {
    anim::travel_by_steps(baked);
  } else if (const std::string named = named_clips(baked, walk_in_place); !named.empty()) {
    into.notes.push_back("clips that walk in place move no agent; LoadOptions::walk_in_place lets them: " + named);
  }
  if (!options.keep_keys) anim::keep_played_streams(baked);
  auto body = std::make_shared<const CharacterBody>(std::move(model), std::move(ragdoll), options.keep_meshes);
  into.characters.push_back(character_of(std::move(baked), std::move(body)));
}

Result<LoadedFile> load(const std::string& path, const LoadOptions& options) {
  if (const Status valid = detail::check_options(path, options); !valid) return valid.error();
#if defined(THRONG_HAS_PACK)
  const auto bytes = options.copy_pack ? pack::PackBytes::copied : pack::PackBytes::mapped;
  if (pack::is_pack(path)) return load_pack(path, pack::Pack::open(path, bytes), options);
#endif
#if defined(THRONG_HAS_IMPORT)
  return load_gltf(path, options, {});
#else
  return no_gltf(path);
#endif
}

Result<LoadedFile> load(std::span<const FileInMemory> files, const LoadOptions& options) {
  if (files.empty()) return anim::refuse({"load", "there is no file: the first is the model"});
  const std::string name(files.front().name);
  if (const Status valid = detail::check_options(name, options); !valid) return valid.error();
#if defined(THRONG_HAS_PACK)
  if (pack::is_pack(files.front())) return load_pack(name, pack::Pack::open(files.front()), options);
#endif
#if defined(THRONG_HAS_IMPORT)
  return load_gltf(name, options, files);
#else
  return no_gltf(name);
#endif
}

}  // namespace throng
