#include <utility>

#include "engine/anim/api/character_data.h"
#include "engine/anim/asset/placement.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/survey/placement_guess.h"

#if defined(THRONG_HAS_IMPORT)
#include "engine/anim/import/import.h"
#endif
#if defined(THRONG_HAS_PACK)
#include "engine/anim/pack/pack.h"
#endif

namespace throng {
namespace {

#if defined(THRONG_HAS_PACK)
Status load_model(const pack::Pack& pack, std::size_t file, std::size_t model, bool keep_meshes, LoadedFile& into) {
  Result<pack::BakedModel> baked = pack.baked(file, model);
  if (!baked) return baked.error();
  Result<anim::Model> from = pack.model(file, model, *baked);
  if (!from) return from.error();
  into.characters.push_back(detail::make_character(std::move(*from), std::move(baked->character), keep_meshes));
  return Done{};
}

Result<LoadedFile> load_pack(const std::string& path, const LoadOptions& options) {
  const auto bytes = options.copy_pack ? pack::PackBytes::copied : pack::PackBytes::mapped;
  const Result<pack::Pack> pack = pack::Pack::open(path, bytes);
  if (!pack) return pack.error();
  LoadedFile loaded;
  for (std::size_t file = 0; file < pack->file_count(); ++file) {
    for (std::size_t model = 0; model < pack->names(file).size(); ++model) {
      const Status added = load_model(*pack, file, model, options.keep_meshes, loaded);
      if (!added) return added.error();
    }
  }
  return loaded;
}
#endif

#if defined(THRONG_HAS_IMPORT)
Result<LoadedFile> load_gltf(const std::string& path, const LoadOptions& options) {
  Result<anim::ImportedFile> file =
      import::import_file(path, {.strict = options.strict, .memory_limit = options.memory_limit});
  if (!file) return file.error();
  anim::face_forward(*file);
  LoadedFile loaded{.characters = {}, .notes = std::move(file->repairs)};
  for (std::string& note : file->notes) loaded.notes.push_back(std::move(note));
  anim::PlacementChoice choice;
  if (options.scale > 0.0) choice.scale = options.scale;
  for (anim::Model& model : file->models) {
    const anim::GuessedPlacement placed = anim::guess_placement(model, choice);
    anim::place_model(model, placed.placement);
    if (!placed.is_plain) loaded.notes.push_back(placed.reasons);
    anim::Character baked = anim::bake_character(model);
    loaded.characters.push_back(detail::make_character(std::move(model), std::move(baked), options.keep_meshes));
  }
  return loaded;
}
#endif

}  // namespace

Result<LoadedFile> load(const std::string& path, const LoadOptions& options) {
  if (!(options.scale >= 0.0 && options.scale < 1e9)) {
    return Error{path + ": LoadOptions::scale is metres a unit, above 0, or 0 for a guess"};
  }
#if defined(THRONG_HAS_PACK)
  if (pack::is_pack(path)) return load_pack(path, options);
#endif
#if defined(THRONG_HAS_IMPORT)
  return load_gltf(path, options);
#else
  return Error{path + ": this build of the library reads no glTF; bake the file to a pack with `throng bake`"};
#endif
}

}  // namespace throng
