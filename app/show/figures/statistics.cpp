#include "app/show/figures/statistics.h"

#include <algorithm>
#include <utility>

#include "app/files/byte_hash.h"
#include "app/show/stage/stage.h"
#include "engine/base/files/output_file.h"
#include "engine/base/json/json.h"

namespace throng::app {
namespace {

double mean(std::uint64_t sum, std::uint64_t count) {
  return count == 0 ? 0.0 : static_cast<double>(sum) / static_cast<double>(count);
}

Json median_or_null(const SampleCounts& samples) {
  return samples.empty() ? Json(nullptr) : Json(samples.quantile(0.5));
}

Json null_if_empty(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

// A whole number where all agents have equally many.
Json bones_per_agent(const Stage& stage) {
  std::uint64_t bones = 0;
  const std::size_t agents = stage.crowd().size();
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    bones += static_cast<std::uint64_t>(stage.system().agent(agent).character().skeleton.bone_count());
  }
  if (agents > 0 && bones % agents == 0) return bones / agents;
  return mean(bones, agents);
}

// Each with its share, its size and how many agents are it.
Json characters_of(const Stage& stage) {
  Json characters = Json::array();
  const auto numbers = stage.crowd().characters();
  for (const CharacterSource& person : stage.people()) {
    const std::size_t number = characters.elements().size();
    characters.push_back({{"name", person.name},
                          {"share", person.roles.share},
                          {"scale", person.placement.placement.scale},
                          {"placement", person.placement.reasons},
                          {"agents", std::ranges::count(numbers, static_cast<std::uint8_t>(number))}});
  }
  return characters;
}

const char* palette_format(const Stage& stage) {
  std::size_t packed = 0;
  const std::size_t characters = stage.people().size();
  for (std::uint32_t character = 0; character < characters; ++character) {
    if (stage.system().characters().palette_format(character) == PaletteFormat::packed) ++packed;
  }
  if (packed == 0) return "float";
  return packed == characters ? "packed" : "mixed";
}

void add_scheduling(Json& json, const Stage& stage) {
  const anim::ScheduleOptions& schedule = stage.system().figures().schedule();
  std::size_t laid_out = 0;
  std::size_t beside = 0;
  for (const anim::ProcessingUnit& unit : stage.system().figures().units()) {
    laid_out = std::max(laid_out, unit.store().bytes_used());
    beside = std::max(beside, unit.list_bytes());
  }
  json["pus"] = schedule.pus;
  json["schedule"] = schedule.schedule == anim::Schedule::fused ? "fused" : "levels";
  json["local_store_kib"] = schedule.local_store_bytes / 1024;
  json["tile"] = schedule.plan.width;
  json["stream"] = stage.system().options().stream == anim::StreamKind::sampled ? "sampled" : "keyframe";
  json["simd_target"] = stage.system().figures().kernels().target;
  json["pose_hash"] = hex_string(stage.system().figures().pose_hash());
  json["local_store_peak_bytes"] = laid_out;
  json["beside_local_store_bytes"] = beside;
}

// Errors of the whole run; null where they were not measured, or too seldom.
void add_error(Json& json, const ErrorMeter& meter) {
  const anim::ErrorFigures error = meter.since_start();
  const anim::QuantileInterval p99 = meter.intervals_since_start().p99;
  const bool measured = error.samples > 0;
  json["error_px_p50"] = measured ? Json(error.p50) : Json(nullptr);
  json["error_px_p99"] = measured ? Json(error.p99) : Json(nullptr);
  json["error_px_p99_low"] = measured ? Json(p99.low) : Json(nullptr);
  json["error_px_p99_high"] = p99.high ? Json(*p99.high) : Json(nullptr);
  json["error_px_max"] = measured ? Json(error.max) : Json(nullptr);
  json["pop_px_max"] = measured ? Json(error.pop_max) : Json(nullptr);
  json["error_samples"] = error.samples;
}

// Null where there is no such limit.
void add_level_of_detail(Json& json, const LodSums& sums, const Tuning& tuning) {
  const bool by_error = tuning.lod.rule == LodRule::budget;
  const SavedCost saved = sums.saved(tuning.lod.rule);
  const auto held = [&](const LodSums::LimitCount& limit, float asked) {
    return by_error && asked > 0.0F && limit.frames > 0 ? Json(limit.percent()) : Json(nullptr);
  };
  json["lod_tolerance_px"] = by_error ? Json(sums.last.tolerance_px) : Json(nullptr);
  json["binding_limit"] = by_error ? Json(name_of(sums.last.binding)) : Json(nullptr);
  json["error_limit_held_percent"] = held(sums.error, tuning.error_px);
  json["budget_held_percent"] = held(sums.budget, tuning.budget_ms);
  json["predicted_pose_ms_per_frame"] = sums.predicted_ms_a_frame();
  json["cost_culling_percent"] = saved.culling_percent;
  json["cost_skipping_percent"] = saved.skipping_percent;
  json["cost_bones_percent"] = saved.bones_percent;
}

// Null unless events were asked for.
void add_events(Json& json, const std::optional<EventSums>& sums) {
  json["events"] = sums ? Json(sums->events()) : Json(nullptr);
  json["event_hash"] = sums ? Json(hex_string(sums->event_hash())) : Json(nullptr);
  json["place_hash"] = sums ? Json(hex_string(sums->place_hash())) : Json(nullptr);
}

}  // namespace

double median(std::vector<double> values) { return nearest_rank(std::move(values), 0.5); }

void Statistics::add_update(double milliseconds) {
  if (!first_update_ms_) first_update_ms_ = milliseconds;
  update_ms_.add(milliseconds);
}

void Statistics::add_drawn_frame(double milliseconds) {
  if (!first_picture_ms_) first_picture_ms_ = milliseconds;
  frame_ms_.add(milliseconds);
}

void Statistics::set_draw(std::uint32_t draw_calls, std::uint64_t triangles) {
  draw_calls_ = draw_calls;
  triangles_ = triangles;
}

void Statistics::add_report(const Stage& stage) {
  const anim::UpdateReport& report = stage.system().figures().report();
  ++frames_;
  palette_bytes_ += report.palette_bytes;
  dma_in_ += report.copies.bytes_in;
  dma_out_ += report.copies.bytes_out;
  dma_transfers_ += report.copies.transfers;
  stream_bytes_ += stage.system().figures().stream_bytes();
  agents_updated_ += report.agents_updated;
  bones_evaluated_ += report.bones_evaluated;
  agents_demoted_ += stage.posed().mesh_choice().figures().demoted;
  triangle_budget_.add(stage.posed().mesh_choice().figures().budget_held);
  lod_.add(stage.posed().level_of_detail().figures());
}

Status Statistics::write(const std::string& path, const Stage& stage, const DrawnBy& drawn_by) const {
  Json json;
  json["agents"] = stage.crowd().size();
  json["characters"] = characters_of(stage);
  json["bones_per_agent"] = bones_per_agent(stage);
  json["frames"] = frames_;
  add_scheduling(json, stage);
  json["start_characters_ms"] = start.characters_ms;
  json["start_device_ms"] = start.device_ms;
  json["spawn_ms"] = start.spawn_ms;
  json["start_meshes_ms"] = start.meshes_ms;
  json["first_update_ms"] = first_update_ms_ ? Json(*first_update_ms_) : Json(nullptr);
  json["first_picture_ms"] = first_picture_ms_ ? Json(*first_picture_ms_) : Json(nullptr);
  json["update_ms_median"] = update_ms_.quantile(0.5);
  json["update_ms_p99"] = update_ms_.quantile(0.99);
  json["update_ms_mean"] = update_ms_.mean();
  json["update_ms_max"] = update_ms_.most();
  json["frame_ms_median"] = median_or_null(frame_ms_);
  json["overlay_ms_median"] = median_or_null(overlay_ms_);
  json["draw_calls"] = draw_calls_;
  json["triangles"] = triangles_;
  json["agents_demoted_per_frame"] = mean(agents_demoted_, frames_);
  json["triangle_budget_held_percent"] =
      stage.tuning().triangle_budget > 0 ? Json(triangle_budget_.percent()) : Json(nullptr);
  json["palette_format"] = palette_format(stage);
  json["palette_bytes_per_frame"] = mean(palette_bytes_, frames_);
  json["dma_in_bytes_per_frame"] = mean(dma_in_, frames_);
  json["dma_out_bytes_per_frame"] = mean(dma_out_, frames_);
  json["dma_transfers_per_frame"] = mean(dma_transfers_, frames_);
  json["stream_bytes_per_frame"] = mean(stream_bytes_, frames_);
  json["agents_updated_per_frame"] = mean(agents_updated_, frames_);
  json["bones_evaluated_per_frame"] = mean(bones_evaluated_, frames_);
  add_error(json, stage.posed().error_meter());
  add_level_of_detail(json, lod_, stage.tuning());
  add_events(json, stage.animated().event_sums());
  json["gl_version"] = null_if_empty(drawn_by.gl_version);
  json["gl_renderer"] = null_if_empty(drawn_by.gl_renderer);
  json["context"] = drawn_by.context;
  return write_output(path, json.dump(2) + "\n");
}

}  // namespace throng::app
