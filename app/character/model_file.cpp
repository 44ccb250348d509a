#include "app/character/model_file.h"

#include "app/character/drawn_import.h"
#include "app/character/packed.h"
#include "app/character/skin_choice.h"
#include "engine/anim/pack/pack.h"
#include "engine/base/text/joined.h"
#include "engine/base/text/plain_text.h"

namespace throng::app {
namespace {

Result<anim::ImportedFile> import_for(ModelFileUse use, const std::string& file, const import::ImportOptions& options) {
  switch (use) {
    case ModelFileUse::skins:
      return import::import_skins(file, options);
    case ModelFileUse::clips:
      return import::import_clips(file, options);
    default:
      return import_to_draw(file, options);
  }
}

Result<anim::ImportedFile> read_packed(const CharacterFile& wanted, bool strict) {
  const auto pack = pack::Pack::open(wanted.path, pack::PackBytes::copied);
  if (!pack) return pack.error();
  if (wanted.skin.empty() && pack->file_count() > 1) {
    return Error{plain_text(wanted.path) + ": it holds " + counted(pack->file_count(), "file") +
                 "; say which behind a #: " + joined(packed_names(*pack, false), ", ", " or ")};
  }
  const auto chosen = choose_packed(*pack, wanted.path, wanted.skin);
  if (!chosen) return chosen.error();
  if (strict) {
    if (const Status clean = check_strictly(*pack, chosen->file, wanted.path); !clean) return clean.error();
  }
  return pack->imported(chosen->file);
}

}  // namespace

Result<anim::ImportedFile> read_model_file(const std::string& file, const import::ImportOptions& options,
                                           ModelFileUse use) {
  const CharacterFile wanted = character_file(file);
  return pack::is_pack(wanted.path) ? read_packed(wanted, options.strict) : import_for(use, file, options);
}

}  // namespace throng::app
