#include "app/character/packed.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "app/character/role_table.h"
#include "engine/base/text/joined.h"
#include "engine/base/text/plain_text.h"

namespace throng::app {
namespace {

std::size_t index_in(std::span<const std::string> names, const std::string& name) {
  return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
}

std::vector<std::string> packed_file_names(const pack::Pack& pack) {
  std::vector<std::string> names;
  for (std::size_t file = 0; file < pack.file_count(); ++file) names.push_back(pack.file_name(file));
  return names;
}

/// Says whether the character can be taken as it was baked.
Result<bool> is_as_asked(const pack::BakedModel& baked, const std::string& path, const BoneLodFile* kept,
                         const LoadOptions& options) {
  const bool as_placed =
      options.placement == anim::PlacementChoice{} || options.placement == baked.prepared.placement.choice;
  if (!as_placed || !options.clips_from.empty()) return false;
  if (kept == nullptr) return true;
  const auto rig = RoleFile(path).read_rig();
  if (!rig) return rig.error();
  return rig->empty();
}

/// Returns the order of bones that was kept for the pack, if any.
Result<std::optional<BoneLodChoice>> kept_order(const BoneLodFile* kept, const anim::Skeleton& skeleton) {
  if (kept == nullptr) return std::optional<BoneLodChoice>();
  return kept->read(skeleton);
}

/// `order` is the baked order, which counts unless a person has kept another.
Result<CharacterSource> bake_anew(const pack::Pack& pack, const PackedCharacter& chosen,
                                  const std::optional<BoneLodChoice>& order, const std::string& path,
                                  const BoneLodFile* kept, const LoadOptions& options) {
  auto imported = pack.imported(chosen.file);
  if (!imported) return imported.error();
  const auto clips = read_clip_files(options.clips_from, options.import);
  if (!clips) return clips.error();
  const std::vector<const ClipFile*> pointers = pointers_to(*clips);
  const auto since = kept_order(kept, imported->models[chosen.model].skeleton);
  if (!since) return since.error();
  auto source =
      make_character(*imported, chosen.model,
                     {.path = path, .name = {}, .kept = kept, .placement = options.placement, .clips = pointers});
  if (source && order && !*since) take_order(*source, *order);
  return source;
}

Result<CharacterSource> as_baked(const pack::Pack& pack, const PackedCharacter& chosen, pack::BakedModel baked,
                                 const BoneLodFile* kept) {
  auto model = pack.model(chosen.file, chosen.model, baked);
  if (!model) return model.error();
  CharacterSource source;
  source.model = std::move(*model);
  source.placement = std::move(baked.prepared.placement);
  source.character = std::make_shared<const anim::Character>(std::move(baked.character));
  source.parts_in_file = said_parts(source.model.skeleton);
  source.surface = {.bytes = pack.surface(chosen.file, chosen.model), .lender = pack.lender()};
  source.repairs = pack.header(chosen.file).repairs;
  source.notes = pack.header(chosen.file).notes;
  const auto order = kept_order(kept, source.model.skeleton);
  if (!order) return order.error();
  if (*order) take_order(source, **order);
  guess_roles(source);
  return source;
}

}  // namespace

Result<PackedCharacter> choose_packed(const pack::Pack& pack, const std::string& path, const std::string& skin) {
  if (skin.empty()) return PackedCharacter{};
  const std::vector<std::string> files = packed_file_names(pack);
  if (const std::size_t file = index_in(files, skin); file < files.size()) return PackedCharacter{file, 0};
  std::vector<std::string> all;
  for (std::size_t file = 0; file < pack.file_count(); ++file) {
    const auto names = pack.names(file);
    if (const std::size_t model = index_in(names, skin); model < names.size()) return PackedCharacter{file, model};
    all.insert(all.end(), names.begin(), names.end());
  }
  return Error{plain_text(path) + ": it has no character \"" + plain_text(skin) + "\"; it has " +
               joined(pack.file_count() > 1 ? files : all, ", ", " and ")};
}

Status check_strictly(const pack::Pack& pack, std::size_t file, const std::string& path) {
  const std::vector<std::string>& repairs = pack.header(file).repairs;
  if (repairs.empty()) return Done{};
  return Error{plain_text(path) + ": it was baked of a file that was repaired: " + repairs.front() +
               "; mend the file and bake it again, or leave --strict out"};
}

std::vector<std::string> packed_names(const pack::Pack& pack, bool all) {
  std::vector<std::string> names;
  for (std::size_t file = 0; file < pack.file_count(); ++file) {
    const auto characters = pack.names(file);
    const bool by_file = !all || (characters.size() == 1 && pack.file_count() > 1);
    if (by_file) {
      names.push_back(pack.file_name(file));
    } else {
      names.insert(names.end(), characters.begin(), characters.end());
    }
  }
  return names;
}

Result<CharacterSource> take_packed(const pack::Pack& pack, const CharacterFile& wanted, const std::string& name,
                                    const BoneLodFile* kept, const LoadOptions& options) {
  const auto chosen = choose_packed(pack, wanted.path, wanted.skin);
  if (!chosen) return chosen.error();
  if (options.import.strict) {
    if (const Status clean = check_strictly(pack, chosen->file, wanted.path); !clean) return clean.error();
  }
  auto baked = pack.baked(chosen->file, chosen->model);
  if (!baked) return baked.error();
  const auto usable = is_as_asked(*baked, wanted.path, kept, options);
  if (!usable) return usable.error();
  auto source = *usable ? as_baked(pack, *chosen, std::move(*baked), kept)
                        : bake_anew(pack, *chosen, baked->prepared.order, wanted.path, kept, options);
  if (!source) return source;
  const auto names = pack.names(chosen->file);
  source->name = plain_text(name);
  source->cast.assign(names.begin(), names.end());
  source->cast_index = chosen->model;
  return source;
}

}  // namespace throng::app
