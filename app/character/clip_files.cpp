#include "app/character/clip_files.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "app/character/model_file.h"
#include "app/character/source.h"
#include "engine/anim/retarget/retarget.h"
#include "engine/base/text/joined.h"
#include "engine/base/text/plain_text.h"

namespace throng::app {
namespace {

/// The model of a clip file whose bones fit best.
struct ClipSource {
  const anim::Model* model = nullptr;
  std::unique_ptr<anim::Retargeter> retargeter;
};

ClipSource best_source(const anim::ImportedFile& clips, const anim::Skeleton& skeleton) {
  ClipSource best;
  for (const anim::Model& model : clips.models) {
    if (model.clips.empty()) continue;
    auto retargeter = std::make_unique<anim::Retargeter>(model.skeleton, skeleton);
    const bool is_better = best.model == nullptr || retargeter->match().matched() > best.retargeter->match().matched();
    if (is_better) best = {&model, std::move(retargeter)};
  }
  return best;
}

/// Mixamo calls every clip "mixamo.com".
bool says_something(const std::string& name) { return !name.empty() && name.find("mixamo.com") == std::string::npos; }

/// Gives clips of a file names that no other clip has.
class ClipNames {
 public:
  ClipNames(const std::string& clip_file, const std::vector<std::string>& taken)
      : stem_(plain_text(std::filesystem::path(clip_file).stem().string())), taken_(taken.begin(), taken.end()) {}

  /// Returns the clip's name, or its file's, with a number behind it where it is taken.
  std::string name_for(const anim::Clip& clip) {
    std::string wanted = says_something(clip.name) ? clip.name : stem_;
    if (taken_.contains(wanted) && wanted != stem_) wanted = stem_ + " " + wanted;
    int& number = numbers_.try_emplace(wanted, 1).first->second;
    std::string name = wanted;
    while (!taken_.insert(name).second) name = wanted + " " + std::to_string(++number);
    return name;
  }

 private:
  std::string stem_;
  std::unordered_set<std::string> taken_;
  std::unordered_map<std::string, int> numbers_;  // the last number that stands behind a name
};

std::string listed(const std::set<std::string>& bones) {
  constexpr std::size_t most = 8;
  std::vector<std::string> names(bones.begin(), bones.end());
  names.resize(std::min(names.size(), most));
  const std::string more = bones.size() > most ? " and " + std::to_string(bones.size() - most) + " more" : "";
  return joined(names) + more;
}

std::string how_they_fit(const anim::Retargeter& retargeter, bool as_they_were) {
  if (as_they_were) return "with their keys as they are";
  char text[96];
  std::snprintf(text, sizeof(text),
                "fitted to this body: ways and heights times %.3g, as the lengths of the legs differ",
                retargeter.plan().scale);
  return text;
}

Error no_clips(const std::string& clip_file) {
  return {plain_text(clip_file) + ": it has no clips; give a file with animations to --clips-from"};
}

Error no_bone_in_common(const std::string& clip_file, const std::string& file) {
  return {plain_text(clip_file + ": no bone of " + file + " has the name or the part of one of its bones; say in " +
                     file + ".throng.json, under \"rig\", which is which")};
}

/// A two-legged walk does not suit a four-legged rest pose. Files of clips, though, may rest in any pose.
bool walks_otherwise(const anim::RetargetPlan& plan) {
  return plan.own_carriage == anim::Carriage::bent && plan.source_carriage == anim::Carriage::upright;
}

Error another_body(const std::string& clip_file, const std::string& file) {
  return {plain_text(clip_file + ": its body stands upright, and the trunk of " + file +
                     " lies across its legs, as on four feet; give --clips-from clips of a body like it, or "
                     "export a person standing")};
}

/// Returns whether the clips of `clip_file` suit the model of `file` to which `source` was matched.
Status check_source(const ClipSource& source, const std::string& clip_file, const std::string& file) {
  if (source.model == nullptr) return no_clips(clip_file);
  if (source.retargeter->match().matched() == 0) return no_bone_in_common(clip_file, file);
  return walks_otherwise(source.retargeter->plan()) ? Status(another_body(clip_file, file)) : Done{};
}

/// Weights of morphs belong to another surface; clips that have nothing else are left out.
void leave_out_morphs(std::vector<anim::Clip>& clips) {
  for (anim::Clip& clip : clips) clip.morph_tracks.clear();
  std::erase_if(clips, [](const anim::Clip& clip) { return clip.tracks.empty(); });
}

Status prepare_for_others(const std::string& path, anim::ImportedFile& file) {
  for (anim::Model& model : file.models) {
    leave_out_morphs(model.clips);
    if (const auto taken = take_kept_rig(path, model.skeleton); !taken) return taken.error();
  }
  return Done{};
}

Result<ClipFile> read_clip_file(const std::string& path, const import::ImportOptions& options) {
  auto clips = read_model_file(path, options, ModelFileUse::clips);
  if (!clips) return clips.error();
  if (const Status taken = prepare_for_others(path, *clips); !taken) return taken.error();
  return ClipFile{.path = path, .imported = std::move(*clips)};
}

std::string plays_none(const ClipFile& clips, const char* why) {
  return "it plays none of the clips of " + plain_text(clips.path) + ", because " + why;
}

void take_clips(const ClipFile& clips, const ClipSource& source, anim::ImportedFile& file, anim::Model& model) {
  std::set<std::string> lost;
  bool as_they_were = true;
  const anim::RetargetPlan& plan = source.retargeter->plan();
  if (plan.own_carriage == anim::Carriage::upright && plan.source_carriage == anim::Carriage::bent) {
    file.notes.push_back(plain_text(clips.path) +
                         ": its body rests bent and this one upright; look whether its clips are those of an animal");
  }
  ClipNames names(clips.path, file.animations);
  for (const anim::Clip& clip : source.model->clips) {
    anim::RetargetedClip fitted = source.retargeter->retarget(clip);
    fitted.clip.name = names.name_for(clip);
    fitted.clip.animation = static_cast<int>(file.animations.size());
    file.animations.push_back(fitted.clip.name);
    model.clips.push_back(std::move(fitted.clip));
    lost.insert(fitted.lost.begin(), fitted.lost.end());
    as_they_were = as_they_were && fitted.as_it_was;
  }
  file.notes.push_back(plain_text(clips.path) + ": " + counted(source.model->clips.size(), "clip") + " taken, " +
                       how_they_fit(*source.retargeter, as_they_were) +
                       (lost.empty() ? "" : "; left out the motion of bones that this body lacks: " + listed(lost)) +
                       (source.model->morphs.empty() ? "" : "; weights of its morph targets left out"));
}

Error no_skeleton(const std::string& path) {
  return {plain_text(path) + ": it holds no skin, so clips of other files have no character to play them"};
}

}  // namespace

Result<std::vector<ClipFile>> read_clip_files(std::span<const std::string> paths,
                                              const import::ImportOptions& options) {
  std::vector<ClipFile> files;
  for (const std::string& path : paths) {
    auto file = read_clip_file(path, options);
    if (!file) return file.error();
    files.push_back(std::move(*file));
  }
  return files;
}

bool has_clips_alone(const std::string& path) { return import::holds_clips_alone(path); }

std::optional<ClipFile> read_clips_alone(const std::string& path, const import::ImportOptions& options) {
  auto file = import::import_clips(path, options);
  return file ? take_clips_alone(path, *file) : std::nullopt;
}

std::optional<ClipFile> take_clips_alone(const std::string& path, anim::ImportedFile& file) {
  const auto draws = [](const anim::Model& model) { return !model.meshes.empty(); };
  const auto plays = [](const anim::Model& model) { return !model.clips.empty(); };
  if (std::ranges::any_of(file.models, draws) || std::ranges::none_of(file.models, plays)) return {};
  if (!prepare_for_others(path, file)) return {};
  return ClipFile{.path = path, .imported = std::move(file)};
}

std::vector<const ClipFile*> pointers_to(std::span<const ClipFile> files) {
  std::vector<const ClipFile*> pointers;
  for (const ClipFile& file : files) pointers.push_back(&file);
  return pointers;
}

Status check_clips(const ClipFile& clips, const anim::Skeleton& skeleton, const std::string& file) {
  return check_source(best_source(clips.imported, skeleton), clips.path, file);
}

Result<std::vector<std::string>> add_clips_from(std::span<const ClipFile* const> clip_files, anim::ImportedFile& file,
                                                std::size_t model) {
  std::vector<std::string> taken;
  for (const ClipFile* const clips : clip_files) {
    const ClipSource source = best_source(clips->imported, file.models[model].skeleton);
    const Status fits = check_source(source, clips->path, file.file);
    if (!fits && (clips->must_fit || source.model == nullptr)) return fits.error();
    if (fits) {
      take_clips(*clips, source, file, file.models[model]);
      taken.push_back(clips->path);
    } else {
      const bool has_bones = source.retargeter->match().matched() > 0;
      file.notes.push_back(
          plays_none(*clips, has_bones ? "they are of a body that stands upright" : "no bone matches"));
    }
  }
  return taken;
}

Status add_clips_to(const std::string& path, std::span<const std::string> clip_files, anim::ImportedFile& file,
                    const import::ImportOptions& options) {
  if (file.models.empty()) return clip_files.empty() ? Status(Done{}) : no_skeleton(path);
  if (const auto taken = take_kept_rig(path, file.models.front().skeleton); !taken) return taken.error();
  const auto clips = read_clip_files(clip_files, options);
  if (!clips) return clips.error();
  const auto added = add_clips_from(pointers_to(*clips), file, 0);
  return added ? Status(Done{}) : Status(added.error());
}

}  // namespace throng::app
