#include "app/commands/pose/command.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <utility>

#include "app/character/clip_files.h"
#include "app/character/model_file.h"
#include "app/commands/pose/dump.h"
#include "app/commands/pose/pipe.h"
#include "app/files/exit_status.h"
#include "engine/base/files/output_file.h"
#include "engine/base/json/json.h"

namespace throng::app {

namespace {

/// A skin with the model it belongs to.
struct PosedSkin {
  const anim::Model* model;
  const anim::Skin* skin;
};

/// Every skin of every model, in the order of the file.
std::vector<PosedSkin> skins_of(const anim::ImportedFile& file) {
  std::vector<PosedSkin> skins;
  for (const anim::Model& model : file.models) {
    for (const anim::Skin& skin : model.skins) skins.push_back({.model = &model, .skin = &skin});
  }
  std::ranges::sort(skins, {}, [](const PosedSkin& posed) { return posed.skin->skin; });
  return skins;
}

const anim::Clip* find_clip(const anim::Model& model, std::optional<int> animation) {
  if (!animation) return nullptr;
  const auto clip = std::ranges::find(model.clips, *animation, &anim::Clip::animation);
  return clip == model.clips.end() ? nullptr : &*clip;
}

Json describe_clip(const anim::ImportedFile& file, std::optional<int> animation) {
  if (!animation) return nullptr;
  const std::string& name = file.animations[static_cast<std::size_t>(*animation)];
  for (const anim::Model& model : file.models) {
    if (const anim::Clip* found = find_clip(model, animation)) {
      return {{"duration", found->duration}, {"index", *animation}, {"name", name}, {"start", found->start}};
    }
  }
  return {{"index", *animation}, {"name", name}};
}

Result<Json> sample_json(const anim::ImportedFile& file, std::optional<int> animation, double seconds, PosePipe& pipe) {
  std::vector<BonePose> poses;
  for (const anim::Model& model : file.models) {
    Result<BonePose> pose = pipe.pose(model, find_clip(model, animation), seconds);
    if (!pose) return pose.error();
    poses.push_back(std::move(*pose));
  }
  Json skins = Json::array();
  for (const PosedSkin& posed : skins_of(file)) {
    const auto model = static_cast<std::size_t>(posed.model - file.models.data());
    skins.push_back(dump_skin(*posed.model, *posed.skin, find_clip(*posed.model, animation), poses[model]));
  }
  return Json{{"skins", std::move(skins)}, {"time", seconds}};
}

/// Returns the index of an animation of the file by its name or, where none has this name, its index; nothing for
/// "none". The error lists the names.
Result<std::optional<int>> find_animation(const anim::ImportedFile& file, const std::string& clip) {
  const auto named = std::ranges::find(file.animations, clip);
  if (named != file.animations.end()) return std::optional(static_cast<int>(named - file.animations.begin()));
  if (clip == "none") return std::optional<int>();
  int index = -1;
  const auto [end, failure] = std::from_chars(clip.data(), clip.data() + clip.size(), index);
  const bool is_index = failure == std::errc() && end == clip.data() + clip.size();
  if (is_index && index >= 0 && static_cast<std::size_t>(index) < file.animations.size()) return std::optional(index);
  std::string message = file.file + ": there is no clip \"" + clip + "\"; choose none";
  for (std::size_t i = 0; i < file.animations.size(); ++i) {
    message.append(", ").append(std::to_string(i)).append(" \"").append(file.animations[i]).append("\"");
  }
  return Error{message};
}

Result<std::string> pose_json(const anim::ImportedFile& file, std::optional<int> animation,
                              const std::vector<double>& times, PosePipe& pipe) {
  Json skins = Json::array();
  for (const PosedSkin& posed : skins_of(file)) skins.push_back(describe_skin(*posed.model, *posed.skin));
  Json samples = Json::array();
  for (const double seconds : times) {
    Result<Json> sample = sample_json(file, animation, seconds, pipe);
    if (!sample) return sample.error();
    samples.push_back(std::move(*sample));
  }
  const Json dump = {{"clip", describe_clip(file, animation)},
                     {"file", file.file},
                     {"program", "throng"},
                     {"samples", std::move(samples)},
                     {"skins", std::move(skins)}};
  return dump.dump() + "\n";
}

Result<std::string> import_and_pose(const PoseOptions& options) {
  auto file = read_model_file(options.model, options.reading, ModelFileUse::skins);
  if (!file) return file.error();
  if (!options.clips_from.empty()) {
    const Status added = add_clips_to(options.model, options.clips_from, *file, options.reading);
    if (!added) return added.error();
  }
  const auto animation = find_animation(*file, options.clip);
  if (!animation) return animation.error();
  PosePipe pipe(options.stream);
  return pose_json(*file, *animation, options.times, pipe);
}

}  // namespace

int run_pose(const PoseOptions& options) {
  const auto text = import_and_pose(options);
  return end_with(text ? write_output(options.json, *text) : text.error());
}

}  // namespace throng::app
