#include "app/commands/pose/command.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdio>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/commands/pose/dump.h"
#include "app/commands/pose/pipe.h"
#include "app/files/atomic_file.h"
#include "app/files/exit_status.h"
#include "engine/anim/import/import.h"

namespace throng::app {

namespace {

using nlohmann::json;

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

json describe_clip(const anim::ImportedFile& file, std::optional<int> animation) {
  if (!animation) return nullptr;
  json clip = {{"index", *animation}, {"name", file.animations[static_cast<std::size_t>(*animation)]}};
  for (const anim::Model& model : file.models) {
    if (const anim::Clip* found = find_clip(model, animation)) {
      clip["start"] = found->start;
      clip["duration"] = found->duration;
      break;
    }
  }
  return clip;
}

anim::Result<json> sample_json(const anim::ImportedFile& file, std::optional<int> animation, double seconds,
                               PosePipe& pipe) {
  std::vector<BonePose> poses;
  for (const anim::Model& model : file.models) {
    anim::Result<BonePose> pose = pipe.pose(model, find_clip(model, animation), seconds);
    if (!pose) return pose.error();
    poses.push_back(std::move(*pose));
  }
  json skins = json::array();
  for (const PosedSkin& posed : skins_of(file)) {
    const auto model = static_cast<std::size_t>(posed.model - file.models.data());
    skins.push_back(dump_skin(*posed.model, *posed.skin, find_clip(*posed.model, animation), poses[model]));
  }
  return json{{"time", seconds}, {"skins", std::move(skins)}};
}

/// Index among the file's animations of a name or, where none is called so, an index; nothing for "none". The error
/// lists what there is.
anim::Result<std::optional<int>> find_animation(const anim::ImportedFile& file, const std::string& clip) {
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
  return anim::Error{message};
}

anim::Result<std::string> pose_json(const anim::ImportedFile& file, std::optional<int> animation,
                                    const std::vector<double>& times, PosePipe& pipe) {
  json skins = json::array();
  for (const PosedSkin& posed : skins_of(file)) skins.push_back(describe_skin(*posed.model, *posed.skin));
  json samples = json::array();
  for (const double seconds : times) {
    anim::Result<json> sample = sample_json(file, animation, seconds, pipe);
    if (!sample) return sample.error();
    samples.push_back(std::move(*sample));
  }
  const json dump = {{"program", "throng"},
                     {"file", file.file},
                     {"clip", describe_clip(file, animation)},
                     {"skins", std::move(skins)},
                     {"samples", std::move(samples)}};
  return dump.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
}

anim::Result<std::string> import_and_pose(const PoseOptions& options) {
  const auto file = import::import_skins(options.model);
  if (!file) return file.error();
  const auto animation = find_animation(*file, options.clip);
  if (!animation) return animation.error();
  PosePipe pipe(options.stream);
  return pose_json(*file, *animation, options.times, pipe);
}

}  // namespace

int run_pose(const PoseOptions& options) {
  const auto text = import_and_pose(options);
  if (!text) return end_with(exit_job_failed, text.error().message);
  if (const auto written = write_output(options.json, *text); !written) {
    return end_with(exit_job_failed, written.error().message);
  }
  return exit_done;
}

}  // namespace throng::app
