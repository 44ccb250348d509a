#include "app/window/panel/controls/ui_map.h"

#include <cstddef>

#include "app/character/rig_table.h"
#include "app/settings/choices.h"
#include "app/settings/preset.h"
#include "engine/base/json/json.h"

namespace throng::app {
namespace {

template <std::size_t Count, class Choice>
const char* word(const std::array<const char*, Count>& words, Choice choice) {
  return words.at(static_cast<std::size_t>(choice));
}

/// The values of presets, and the ways to look at level of detail, which presets do not keep.
Json tuning_json(const Tuning& tuning) {
  Json json = to_json(Preset{.tuning = tuning, .camera = {}});
  const LodInspection& look = tuning.inspection;
  json["inspection"] = {{"freeze_camera", look.freeze_camera},
                        {"thresholds", look.thresholds},
                        {"figures_above_heads", look.figures_above_heads},
                        {"split", word(split_words, look.split)},
                        {"split_at", look.split_at}};
  return json;
}

Json entity_json(const EntityRow& row) {
  return {{"kind", row.kind}, {"clip", row.clip}, {"weight", row.weight}, {"bytes", row.block.size()}};
}

Json layer_json(const LayerRow& layer) {
  return {{"name", layer.name}, {"weight", layer.weight}, {"entities", layer.entities}};
}

Json tracked_json(const std::shared_ptr<const TrackedPerson>& person) {
  if (person == nullptr) return nullptr;
  return {{"id", person->id},
          {"first", person->presence.first},
          {"last", person->presence.last},
          {"footfalls", person->footfalls.size()}};
}

Json selected_json(const std::optional<SelectionReport>& selected) {
  if (!selected) return nullptr;
  Json entities = Json::array();
  for (const EntityRow& row : selected->entities) entities.push_back(entity_json(row));
  Json layers = Json::array();
  for (const LayerRow& layer : selected->layers) layers.push_back(layer_json(layer));
  return {{"agent", selected->agent},
          {"posture", word(posture_words, selected->posture)},
          {"x", selected->x},
          {"y", selected->y},
          {"z", selected->z},
          {"bytes", selected->bytes},
          {"entities", entities},
          {"layers", layers},
          {"held_at", selected->held_at},
          {"tracked", tracked_json(selected->tracked)},
          {"history_frames", selected->history.size()},
          {"events", selected->events}};
}

Json bone_names(const FrameReport& report) {
  Json names = Json::array();
  for (const BoneRow& bone : report.bones) names.push_back(bone.name);
  return names;
}

Json sweep_json(const SweepCurve& sweep) {
  if (sweep.stops.empty()) return nullptr;
  Json stops = Json::array();
  for (const SweepStop& stop : sweep.stops) {
    stops.push_back({{"value", stop.value},
                     {"refused", stop.refused},
                     {"update_ms", stop.known ? Json(stop.cost.milliseconds) : Json(nullptr)}});
  }
  return {{"value", word(swept_value_words, sweep.value)}, {"runs", sweep.runs}, {"stops", stops}};
}

Json error_json(const ErrorReport& error) {
  const anim::ErrorFigures& figures = error.figures;
  return {{"p50", figures.p50},     {"p99", figures.p99},         {"max", figures.max},
          {"pop", figures.pop_max}, {"samples", figures.samples}, {"history", error.p99_history.size()}};
}

Json cast_json(const std::vector<CastMember>& cast) {
  Json members = Json::array();
  for (const CastMember& member : cast) members.push_back({{"share", member.share}, {"agents", member.agents}});
  return members;
}

Json body_json(const BodyParts& body) {
  return {{"said", rig_json(body.chosen)}, {"follows", body.follows}, {"refusal", body.refusal}};
}

Json replay_json(const std::optional<ReplayReport>& replay) {
  if (!replay) return nullptr;
  return {{"frame", replay->frame},   {"frames", replay->frames},   {"sought", replay->sought.value_or(0)},
          {"paused", replay->paused}, {"loops", replay->loops},     {"speed", replay->speed},
          {"ended", replay->ended},   {"differs", replay->differs}, {"outcome", replay->outcome}};
}

Json tracks_json(const std::optional<TracksReport>& tracks) {
  if (!tracks) return nullptr;
  const TrackClock& clock = tracks->clock;
  return {{"seconds", clock.seconds}, {"first", clock.first},     {"last", clock.last},
          {"rate", clock.rate},       {"repeats", clock.repeats}, {"people", tracks->people->at(clock.seconds)}};
}

Json cameras_json(const CameraReport& cameras) {
  return {
      {"films", cameras.films}, {"follows", cameras.follows}, {"fly_speed", cameras.fly_speed}, {"kept", cameras.kept}};
}

Json viewer_json(const std::optional<ViewerReport>& viewer) {
  if (!viewer) return nullptr;
  const ViewerSettings& settings = viewer->settings;
  return {{"character", viewer->character},
          {"clip", viewer->clips[static_cast<std::size_t>(settings.clip)].name},
          {"seconds", viewer->seconds},
          {"length", viewer->length},
          {"plays", settings.plays},
          {"bind_pose", settings.bind_pose},
          {"blended", settings.blended},
          {"weight", settings.weight},
          {"bone_level", settings.bone_level},
          {"mesh_lod", settings.mesh_lod},
          {"preview", viewer->preview ? Json(role_names.at(index_of(viewer->preview->role))) : Json(nullptr)}};
}

Json jobs_json(const std::vector<JobReport>& jobs) {
  Json all = Json::array();
  for (const JobReport& job : jobs) all.push_back({{"words", job.words}, {"share", job.share}});
  return all;
}

Json report_json(const FrameReport& report) {
  return {{"agents", report.agents},
          {"characters", report.characters},
          {"cast", cast_json(report.cast)},
          {"drawn", report.drawn},
          {"visible", report.visible},
          {"agents_updated", report.work.agents_updated},
          {"agents_by_interval", report.agents_by_interval},
          {"agents_by_bone_level", report.agents_by_bone_level},
          {"level_bone_counts", report.level_bone_counts},
          {"bones", bone_names(report)},
          {"body", body_json(report.body)},
          {"heads", report.heads.size()},
          {"thresholds", report.thresholds.size()},
          {"threshold_clip", report.threshold_clip},
          {"pus", report.schedule.pus},
          {"local_store_kib", report.schedule.local_store_bytes / bytes_a_kib},
          {"tile", report.schedule.plan.width},
          {"snapshots", report.snapshots.size()},
          {"preset_names", report.preset_names},
          {"timeline_frames", report.timeline.size()},
          {"kept_frames", report.kept.numbers},
          {"looked_at", report.kept.looked_at ? Json(report.kept.looked_at->number()) : Json(nullptr)},
          {"error", error_json(report.error)},
          {"sweep", sweep_json(report.sweep)},
          {"notice", report.notice},
          {"message", report.messages.all().empty() ? "" : report.messages.all().back().words},
          {"jobs", jobs_json(report.jobs)},
          {"cameras", cameras_json(report.cameras)},
          {"replay", replay_json(report.replay)},
          {"tracks", tracks_json(report.tracks)},
          {"selected", selected_json(report.selected)},
          {"viewer", viewer_json(report.viewer)}};
}

Json camera_json(const CameraPose& camera) {
  return {{"x", camera.x},     {"y", camera.y},         {"z", camera.z},
          {"yaw", camera.yaw}, {"pitch", camera.pitch}, {"field_of_view", camera.field_of_view}};
}

}  // namespace

std::string to_json(const UiMap& map, const Tuning& tuning, const FrameReport& report) {
  Json widgets = Json::object();
  for (const auto& [name, place] : map.widgets) {
    widgets[name] = {{"x", place.x}, {"y", place.y}, {"w", place.width}, {"h", place.height}};
  }
  Json idle = Json::object();
  for (const auto& [row, reason] : map.idle) idle[row] = reason;
  const Json document = {{"frame", report.frame},
                         {"size", Json::array({map.width, map.height})},
                         {"tab", map.tab},
                         {"hidden", map.hidden},
                         {"help", map.help},
                         {"shows_b", map.shows_b},
                         {"typing", map.typing},
                         {"focus", map.focus},
                         {"tuning", tuning_json(tuning)},
                         {"report", report_json(report)},
                         {"camera", camera_json(report.camera)},
                         {"idle", idle},
                         {"widgets", widgets}};
  // A model's name may hold bytes that are not UTF-8.
  return document.dump(1) + "\n";
}

}  // namespace throng::app
