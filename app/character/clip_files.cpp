#include "app/character/clip_files.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "app/character/source.h"
#include "app/files/joined.h"
#include "engine/anim/base/plain_text.h"
#include "engine/anim/retarget/retarget.h"

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
    const bool is_better = !best.model || retargeter->match().matched() > best.retargeter->match().matched();
    if (is_better) best = {&model, std::move(retargeter)};
  }
  return best;
}

/// Mixamo calls every clip "mixamo.com".
bool says_something(const std::string& name) { return !name.empty() && name.find("mixamo.com") == std::string::npos; }

/// Returns the clip's name, or that of its file, made one that no other clip has.
std::string name_for(const anim::Clip& clip, const std::string& clip_file, const std::vector<std::string>& taken) {
  const std::string stem = anim::plain_text(std::filesystem::path(clip_file).stem().string());
  std::string name = says_something(clip.name) ? clip.name : stem;
  if (std::ranges::count(taken, name) > 0 && name != stem) name = stem + " " + name;
  const std::string wanted = name;
  for (int number = 2; std::ranges::count(taken, name) > 0; ++number) name = wanted + " " + std::to_string(number);
  return name;
}

std::string listed(const std::set<std::string>& bones) {
  constexpr std::size_t most = 8;
  std::vector<std::string> names(bones.begin(), bones.end());
  names.resize(std::min(names.size(), most));
  const std::string more = bones.size() > most ? " and " + std::to_string(bones.size() - most) + " more" : "";
  return joined(names) + more;
}

std::string how_they_fit(const anim::Retargeter& retargeter, bool as_they_were) {
  if (as_they_were) return "with their keys as they are";
  char text[64];
  std::snprintf(text, sizeof(text), "retargeted to legs %.3g times as long", retargeter.plan().scale);
  return text;
}

anim::Error no_clips(const std::string& clip_file) {
  return {anim::plain_text(clip_file) + ": it has no clips; give a file with animations to --clips-from"};
}

anim::Error no_bone_in_common(const std::string& clip_file, const std::string& file) {
  return {anim::plain_text(clip_file + ": no bone of " + file +
                           " has the name or the part of one of its bones; say in " + file +
                           ".throng.json, under \"rig\", which is which")};
}

/// Weights of morphs are those of another surface; clips that have nothing else go.
void leave_out_morphs(std::vector<anim::Clip>& clips) {
  for (anim::Clip& clip : clips) clip.morph_tracks.clear();
  std::erase_if(clips, [](const anim::Clip& clip) { return clip.tracks.empty(); });
}

anim::Result<anim::ImportedFile> import_clip_file(const std::string& clip_file, const import::ImportOptions& options) {
  auto clips = import::import_clips(clip_file, options);
  if (!clips) return clips.error();
  for (anim::Model& model : clips->models) {
    leave_out_morphs(model.clips);
    if (const anim::Status taken = take_kept_rig(clip_file, model.skeleton); !taken) return taken.error();
  }
  return clips;
}

anim::Status add_clips(const std::string& clip_file, anim::ImportedFile& file, anim::Model& model,
                       const import::ImportOptions& options) {
  const auto clips = import_clip_file(clip_file, options);
  if (!clips) return clips.error();
  const ClipSource source = best_source(*clips, model.skeleton);
  if (!source.model) return no_clips(clip_file);
  if (source.retargeter->match().matched() == 0) return no_bone_in_common(clip_file, file.file);
  std::set<std::string> lost;
  bool as_they_were = true;
  for (const anim::Clip& clip : source.model->clips) {
    anim::RetargetedClip fitted = source.retargeter->retarget(clip);
    fitted.clip.name = name_for(clip, clip_file, file.animations);
    fitted.clip.animation = static_cast<int>(file.animations.size());
    file.animations.push_back(fitted.clip.name);
    model.clips.push_back(std::move(fitted.clip));
    lost.insert(fitted.lost.begin(), fitted.lost.end());
    as_they_were = as_they_were && fitted.as_it_was;
  }
  file.notes.push_back(anim::plain_text(clip_file) + ": " + counted(source.model->clips.size(), "clip") + " taken, " +
                       how_they_fit(*source.retargeter, as_they_were) +
                       (lost.empty() ? "" : "; nobody follows its bones " + listed(lost)) +
                       (source.model->morphs.empty() ? "" : "; weights of its morph targets left out"));
  return anim::Done{};
}

anim::Error no_skeleton(const std::string& path) {
  return {anim::plain_text(path) + ": it holds no skin, so clips of other files have nobody to play them"};
}

}  // namespace

anim::Status add_clips_from(std::span<const std::string> clip_files, anim::ImportedFile& file, std::size_t model,
                            const import::ImportOptions& options) {
  for (const std::string& clip_file : clip_files) {
    const anim::Status added = add_clips(clip_file, file, file.models[model], options);
    if (!added) return added;
  }
  return anim::Done{};
}

anim::Status add_clips_to(const std::string& path, std::span<const std::string> clip_files, anim::ImportedFile& file,
                          const import::ImportOptions& options) {
  if (file.models.empty()) return clip_files.empty() ? anim::Status(anim::Done{}) : no_skeleton(path);
  if (const anim::Status taken = take_kept_rig(path, file.models.front().skeleton); !taken) return taken;
  return add_clips_from(clip_files, file, 0, options);
}

bool has_clips_alone(const std::string& file) {
  const auto imported = import::import_clips(file);
  if (!imported || imported->models.empty()) return false;
  const auto draws = [](const anim::Model& model) { return !model.meshes.empty(); };
  const auto plays = [](const anim::Model& model) { return !model.clips.empty(); };
  return std::ranges::none_of(imported->models, draws) && std::ranges::any_of(imported->models, plays);
}

}  // namespace throng::app
