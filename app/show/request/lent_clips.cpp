#include "app/show/request/lent_clips.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

#include "app/character/clip_files.h"
#include "engine/base/text/joined.h"
#include "engine/base/text/plain_text.h"

namespace throng::app {
namespace {

bool plays(const ChosenCharacter& character, const std::string& file) {
  return std::ranges::any_of(character.clip_files, [&](const std::string& other) {
    std::error_code ignored;
    return other == file || std::filesystem::equivalent(other, file, ignored);
  });
}

// Without its folder.
std::string short_name(const std::string& file) { return plain_text(std::filesystem::path(file).filename().string()); }

/// Gives the characters of a crowd other clips.
class ClipLender {
 public:
  explicit ClipLender(std::span<const CharacterSource> people) : people_(people) {
    for (const CharacterSource& person : people) cast_.push_back(chosen(person));
  }

  Status lend(const ClipFile& clips) {
    Status refused = Error{plain_text(clips.path) + ": all characters that are shown play its clips already"};
    bool is_taken = false;
    for (std::size_t i = 0; i < people_.size(); ++i) {
      if (plays(cast_[i], clips.path)) continue;
      if (Status fits = check_clips(clips, people_[i].model.skeleton, people_[i].name); !fits) {
        refused = std::move(fits);
        continue;
      }
      cast_[i].clip_files.push_back(clips.path);
      std::erase_if(cast_[i].clips, [](const RoleChoice& choice) { return choice.clip == no_clip_name; });
      takers_.insert(short_name(people_[i].name));
      is_taken = true;
    }
    return is_taken ? Done{} : refused;
  }

  LentClips lent(std::span<const std::string> files) && {
    std::vector<std::string> names;
    for (const std::string& file : files) names.push_back(short_name(file));
    return {.request = {std::move(cast_)},
            .words = "The clips of " + joined(names, ", ", " and ") + " are lent to " + joined(takers_, ", ", " and ")};
  }

 private:
  std::span<const CharacterSource> people_;
  std::vector<ChosenCharacter> cast_;
  std::set<std::string> takers_;
};

}  // namespace

Result<std::optional<LentClips>> lent_clips(std::span<const std::string> files,
                                            std::span<const CharacterSource> people) {
  if (!std::ranges::all_of(files, has_clips_alone)) return std::optional<LentClips>();
  const auto clips = read_clip_files(files);
  if (!clips) return clips.error();
  ClipLender lender(people);
  for (const ClipFile& file : *clips) {
    if (const Status lent = lender.lend(file); !lent) return lent.error();
  }
  return std::optional(std::move(lender).lent(files));
}

}  // namespace throng::app
