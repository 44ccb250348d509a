#include "app/character/cast_files.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/character/bone_lod.h"
#include "app/character/clip_files.h"
#include "app/character/drawn_import.h"
#include "app/character/model_placement.h"
#include "app/character/packed.h"
#include "app/character/skin_choice.h"
#include "engine/anim/pack/pack.h"
#include "engine/base/text/joined.h"
#include "engine/base/text/plain_text.h"

namespace throng::app {
namespace {

namespace fs = std::filesystem;

/// The endings of files that a folder is searched for.
constexpr std::string_view pack_ending = ".pack";
constexpr std::array<std::string_view, 3> model_endings{".glb", ".gltf", pack_ending};

constexpr std::size_t most_explained = 6;  // of the files that are left out

/// A file of the cast.
struct Member {
  std::string file;  // "FILE" or "FILE#SKIN"
  std::size_t entry = 0;
  bool is_named = true;  // false: a folder holds it, or it came with others
};

/// A file that holds characters, read once.
struct ReadMember {
  Member member;
  const pack::Pack* pack = nullptr;  // holds its one character; then nothing is imported
  anim::ImportedFile imported;
  std::vector<std::string> names;   // of all its characters
  std::vector<std::size_t> chosen;  // the models that are shown
};

std::string ending_of(const fs::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char letter) { return std::tolower(letter); });
  return ending;
}

// Packs beside other files were baked of them, so their characters would be cast twice.
void leave_out_packs_of_others(std::vector<std::string>& files) {
  const auto is_packed = [](const std::string& file) { return ending_of(file) == pack_ending; };
  if (!std::ranges::all_of(files, is_packed)) std::erase_if(files, is_packed);
}

bool is_folder(const std::string& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

// In the order of their names, whatever the order of the folder. Hidden files are other programs' notes.
Result<std::vector<std::string>> models_in(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const bool is_hidden = entry->path().filename().string().starts_with('.');
    if (!is_hidden && is_model_file(entry->path()) && !is_folder(entry->path().string())) {
      files.push_back(entry->path().string());
    }
  }
  if (error) return Error{plain_text(folder) + ": the folder cannot be read: " + error.message()};
  if (files.empty()) {
    return Error{plain_text(folder) + ": the folder holds no " + joined(model_endings, ", ", " or ") +
                 " file; name one that holds models, not in folders below it"};
  }
  leave_out_packs_of_others(files);
  std::ranges::sort(files);
  return files;
}

bool has_surface(const anim::ImportedFile& file) {
  return std::ranges::any_of(file.models, [](const anim::Model& model) { return !model.meshes.empty(); });
}

Error no_mesh(const std::string& path, const anim::Model& model) {
  const std::size_t clips = model.clips.size();
  return {plain_text(path) + ": it has a skeleton of " + counted(model.skeleton.bones.size(), "bone") +
          (clips > 0 ? " and " + counted(clips, "clip") : "") + ", but no mesh to draw; " +
          (clips > 0 ? "name the file of a character with a mesh, and add --clips-from " + plain_text(path)
                     : "export it into one .glb with its mesh")};
}

Error too_many(const std::string& entry) {
  return {plain_text(entry) + ": with it there are more than " + std::to_string(most_models) +
          " characters, the most of one crowd; name fewer, as in --cast FILE,FILE"};
}

class CastLoader {
 public:
  CastLoader(std::span<const CastEntry> entries, const LoadOptions& options, bool came_together)
      : entries_(entries), options_(options), came_together_(came_together) {}

  Result<LoadedCast> load() {
    for (const auto step : {&CastLoader::list, &CastLoader::read_all, &CastLoader::make_all}) {
      if (const Status done = (this->*step)(); !done) return done.error();
    }
    if (cast_.characters.empty()) return no_characters();
    if (!unexplained_.empty()) {
      cast_.left_out.push_back("Left out as well: " + joined(unexplained_, ", ", " and ") + ".");
    }
    share_out();
    return std::move(cast_);
  }

 private:
  Status list() {
    for (std::size_t entry = 0; entry < entries_.size(); ++entry) {
      const CharacterFile wanted = character_file(entries_[entry].file);
      if (!is_folder(wanted.path)) {
        members_.push_back({entries_[entry].file, entry, !came_together_});
        continue;
      }
      const auto files = models_in(wanted.path);
      if (!files && !came_together_) return files.error();
      if (!files) cast_.left_out.push_back(files.error().message + ".");
      for (const std::string& file : files ? *files : std::vector<std::string>()) {
        members_.push_back({with_skin(file, wanted.skin), entry, false});
      }
    }
    return Done{};
  }

  Status read_all() {
    for (const Member& member : members_) {
      const Status read = this->read(member);
      if (Status taken = take(member, read); !taken) return taken;
      if (characters_ > most_models) return too_many(entries_[member.entry].file);
    }
    return Done{};
  }

  Status read(const Member& member) {
    const CharacterFile wanted = character_file(member.file);
    if (pack::is_pack(wanted.path)) return read_pack(member, wanted);
    auto imported = import_to_draw(wanted.path, options_.import);
    if (imported && has_surface(*imported)) return choose(member, wanted.skin, std::move(*imported));
    if (!member.is_named && take_clips(member, wanted.path, imported)) return Done{};
    return imported ? no_mesh(imported->file, imported->models.front()) : imported.error();
  }

  // Opens each pack once. Without a skin it stands for the first character of each file in it.
  Status read_pack(const Member& member, const CharacterFile& wanted) {
    auto known = packs_.find(wanted.path);
    if (known == packs_.end()) {
      auto pack = pack::Pack::open(wanted.path, pack::PackBytes::copied);
      if (!pack) return pack.error();
      known = packs_.emplace(wanted.path, std::move(*pack)).first;
    }
    const pack::Pack& pack = known->second;
    const bool is_whole = wanted.skin.empty() || wanted.skin == all_skins;
    const auto names = is_whole ? packed_names(pack, wanted.skin == all_skins) : std::vector{wanted.skin};
    for (const std::string& name : names) {
      const std::string file = is_whole && names.size() == 1 ? wanted.path : wanted.path + "#" + name;
      const Member one{.file = file, .entry = member.entry, .is_named = member.is_named};
      read_.push_back({.member = one, .pack = &pack, .imported = {}, .names = {}, .chosen = {0}});
    }
    characters_ += names.size();
    return Done{};
  }

  Status choose(const Member& member, const std::string& skin, anim::ImportedFile imported) {
    ReadMember read{
        .member = member, .pack = nullptr, .imported = {}, .names = character_names(imported), .chosen = {}};
    if (skin == all_skins) {
      for (std::size_t i = 0; i < read.names.size(); ++i) read.chosen.push_back(i);
    } else {
      const auto chosen = choose_model(imported, skin);
      if (!chosen) return chosen.error();
      read.chosen.push_back(*chosen);
    }
    characters_ += read.chosen.size();
    read.imported = std::move(imported);
    read_.push_back(std::move(read));
    return Done{};
  }

  // Clips beside characters are for them.
  bool take_clips(const Member& member, const std::string& path, Result<anim::ImportedFile>& imported) {
    auto clips = imported ? take_clips_alone(path, *imported) : read_clips_alone(path, options_.import);
    if (!clips) return false;
    clips->must_fit = false;
    beside_[came_together_ ? 0 : member.entry].push_back(std::move(*clips));
    return true;
  }

  // A file that a person named must be shown. A file of a folder is left out if it cannot be.
  Status take(const Member& member, const Status& status) {
    if (status || member.is_named || options_.import.strict) return status;
    if (cast_.left_out.size() < most_explained) {
      cast_.left_out.push_back(status.error().message + "; it is left out.");
    } else {
      unexplained_.push_back(plain_text(fs::path(member.file).filename().string()));
    }
    return Done{};
  }

  Status make_all() {
    for (ReadMember& read : read_) {
      const auto clips = clips_for(read.member.entry);
      if (!clips) return clips.error();
      for (const std::size_t model : read.chosen) {
        if (Status taken = take(read.member, make(read, model, *clips)); !taken) return taken;
        ++made_;
      }
    }
    return Done{};
  }

  Result<std::vector<const ClipFile*>> clips_for(std::size_t entry) {
    const auto& own = entries_[entry].clip_files;
    std::vector<const ClipFile*> clips;
    for (const std::string& path : own ? *own : options_.clips_from) {
      const auto [file, is_new] = wanted_clips_.try_emplace(path);
      if (is_new) {
        auto read = read_clip_files({&path, 1}, options_.import);
        if (!read) return read.error();
        file->second = std::move(read->front());
      }
      clips.push_back(&file->second);
    }
    if (own) return clips;
    for (const ClipFile& file : beside_[came_together_ ? 0 : entry]) {
      if (!wanted_clips_.contains(file.path)) clips.push_back(&file);
    }
    return clips;
  }

  anim::PlacementChoice placement_of(const Member& member) const {
    const auto& own = entries_[member.entry].placement;
    return own ? *own : placement_for(member.file, options_);
  }

  // A pack takes no clips that lie beside it, for it is baked.
  Result<CharacterSource> make_packed(const ReadMember& read) const {
    const std::string& file = read.member.file;
    const BoneLodFile kept(file);
    LoadOptions options = options_;
    options.placement = placement_of(read.member);
    if (const auto& own = entries_[read.member.entry].clip_files) options.clips_from = *own;
    return take_packed(*read.pack, character_file(file), file, &kept, options);
  }

  Result<CharacterSource> make_imported(ReadMember& read, std::size_t model, const std::string& file,
                                        std::span<const ClipFile* const> clips) const {
    const BoneLodFile kept(file);
    const std::string path = character_file(read.member.file).path;
    auto character = make_character(read.imported, model,
                                    {.path = path,
                                     .name = file,
                                     .kept = &kept,
                                     .placement = placement_of(read.member),
                                     .clips = clips,
                                     .progress = options_.progress ? progress_of_one() : LoadProgress()});
    if (!character) return character;
    character->cast = read.names;
    character->cast_index = model;
    return character;
  }

  Status make(ReadMember& read, std::size_t model, std::span<const ClipFile* const> clips) {
    const CharacterFile wanted = character_file(read.member.file);
    const std::string file = wanted.skin == all_skins ? with_skin(wanted.path, read.names[model]) : read.member.file;
    auto character = read.pack != nullptr ? make_packed(read) : make_imported(read, model, file, clips);
    if (!character) return character.error();
    if (!character->has_surface()) return no_mesh(wanted.path, character->model);
    if (Status seen = check_extent(*character, wanted.path); !seen) return seen;
    character->file = file;
    cast_.characters.push_back(std::move(*character));
    entry_of_.push_back(read.member.entry);
    return Done{};
  }

  LoadProgress progress_of_one() const {
    return [this](double share, const std::string& what) {
      options_.progress((static_cast<double>(made_) + share) / static_cast<double>(characters_), what);
    };
  }

  void share_out() {
    for (std::size_t i = 0; i < entry_of_.size(); ++i) {
      const auto all = static_cast<double>(std::ranges::count(entry_of_, entry_of_[i]));
      const std::optional<double>& share = entries_[entry_of_[i]].share;
      cast_.characters[i].roles.share = share ? *share / all : 1.0;
    }
  }

  Error no_characters() const {
    if (!cast_.left_out.empty()) return {"there is no character to show: " + cast_.left_out.front()};
    const std::string first = entries_.empty() ? "" : plain_text(entries_.front().file) + ": ";
    return {first + "there are clips and no character to play them; give the file of a character with them"};
  }

  std::span<const CastEntry> entries_;
  const LoadOptions& options_;
  bool came_together_;
  std::vector<Member> members_;
  std::vector<ReadMember> read_;
  std::size_t characters_ = 0, made_ = 0;
  std::map<std::string, pack::Pack> packs_;              // by path
  std::map<std::string, ClipFile> wanted_clips_;         // by path
  std::map<std::size_t, std::vector<ClipFile>> beside_;  // by entry
  std::vector<std::size_t> entry_of_;                    // [character]
  std::vector<std::string> unexplained_;                 // names of files
  LoadedCast cast_;
};

}  // namespace

bool is_model_file(const fs::path& file) { return std::ranges::count(model_endings, ending_of(file)) > 0; }

Status check_extent(const CharacterSource& character, const std::string& path) {
  constexpr double least = 1e-9, most = 1e9;  // metres, by which agents are spaced and cameras placed
  const auto is_sensible = [&](double length) { return length > least && length < most; };
  const anim::CharacterBounds& bounds = character.character->bounds;
  if (is_sensible(bounds.height) && is_sensible(bounds.reach)) return Done{};
  return Error{plain_text(path) +
               ": its mesh has no height, or one beyond all measure, so it cannot be shown; export it again"};
}

Result<LoadedCast> load_cast(std::span<const CastEntry> entries, const LoadOptions& options) {
  return CastLoader(entries, options, false).load();
}

Result<LoadedCast> load_dropped(std::span<const std::string> files, const LoadOptions& options) {
  const std::vector<CastEntry> entries = cast_of(files);
  return CastLoader(entries, options, files.size() > 1).load();
}

std::vector<CastEntry> cast_of(std::span<const std::string> files) {
  std::vector<CastEntry> entries;
  for (const std::string& file : files) entries.push_back({.file = file});
  return entries;
}

}  // namespace throng::app
