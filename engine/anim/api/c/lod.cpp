#include <algorithm>

#include "engine/anim/api/c/parts.h"

namespace throng::c {

static_assert(THRONG_LOD_BY_BUDGET == static_cast<int>(LodRule::budget));

namespace {

void write_camera(const Camera& own, throng_camera& camera) {
  write(own.position, camera.position);
  write(own.forward, camera.forward);
  std::memcpy(camera.frustum, own.frustum.data(), sizeof(camera.frustum));
  camera.pixels_per_unit = own.pixels_per_unit;
}

Camera camera_of_c(const throng_camera& camera) {
  Camera own;
  own.position = vector_of(camera.position);
  own.forward = vector_of(camera.forward);
  std::memcpy(own.frustum.data(), camera.frustum, sizeof(camera.frustum));
  own.pixels_per_unit = camera.pixels_per_unit;
  return own;
}

}  // namespace

template <>
throng_camera default_of() {
  throng_camera camera{};
  write_camera(Camera{}, camera);
  return camera;
}

template <>
throng_lod_rules default_of() {
  const LodRules own;
  throng_lod_rules rules{};
  rules.rule = static_cast<uint32_t>(own.rule);
  rules.error_pixels = own.error_pixels;
  rules.full_rate_distance = own.full_rate_distance;
  rules.interval_growth = own.interval_growth;
  rules.largest_interval = static_cast<uint32_t>(own.largest_interval);
  rules.bone_lod = own.bone_lod ? 1 : 0;
  rules.smooth = own.smooth ? 1 : 0;
  std::ranges::copy(own.level_distances, rules.level_distances);
  rules.centre_importance = own.centre_importance;
  rules.centre_degrees = own.centre_degrees;
  rules.budget_milliseconds = own.budget_milliseconds;
  return rules;
}

template <>
throng_lod_frame default_of() {
  return {};
}

namespace {

LodRules rules_of(const throng_lod_rules& rules) {
  LodRules own;
  own.rule = static_cast<LodRule>(rules.rule);
  own.error_pixels = rules.error_pixels;
  own.budget_milliseconds = rules.budget_milliseconds;
  own.full_rate_distance = rules.full_rate_distance;
  own.interval_growth = rules.interval_growth;
  own.largest_interval = static_cast<int>(rules.largest_interval);
  own.bone_lod = rules.bone_lod != 0;
  own.smooth = rules.smooth != 0;
  std::ranges::copy(rules.level_distances, own.level_distances.begin());
  own.centre_importance = rules.centre_importance;
  own.centre_degrees = rules.centre_degrees;
  return own;
}

std::optional<LodFrame> read_frame(const Call& call, const throng_lod_frame* given) {
  const auto frame = call.read("throng_lod_frame", given);
  if (!frame || call.lacks(frame->positions, frame->count)) return {};
  const auto camera = call.read("throng_camera", frame->camera);
  const auto rules = call.read("throng_lod_rules", frame->rules);
  if (!camera || !rules || !call.is_constant("throng_lod_rules::rule", rules->rule, LodRule::budget)) return {};
  LodFrame own;
  own.positions = {reinterpret_cast<const Vec3*>(frame->positions), frame->count};
  if (frame->scales != nullptr) own.scales = {frame->scales, frame->count};
  own.camera = camera_of_c(*camera);
  own.rules = rules_of(*rules);
  own.frame_step = ticks_of(frame->frame_step);
  return own;
}

throng_pose_request c_request_of(const PoseRequest& request) {
  throng_pose_request own{};
  own.agent = id_of(request.agent);
  own.level = request.level;
  own.fade_level = request.fade_level;
  own.fade_halves = request.fade_halves;
  own.look_ahead = to_seconds(request.look_ahead);
  return own;
}

}  // namespace
}  // namespace throng::c

using namespace throng::c;  // NOLINT: functions of C have no namespace

int throng_camera_fill(throng_camera* into, size_t size) { return fill("throng_camera_fill", into, size); }
int throng_lod_rules_fill(throng_lod_rules* into, size_t size) { return fill("throng_lod_rules_fill", into, size); }
int throng_lod_frame_fill(throng_lod_frame* into, size_t size) { return fill("throng_lod_frame_fill", into, size); }

int throng_camera_set(throng_camera* camera, const float position[3], const float forward[3],
                      const float clip_from_world[16], uint32_t pixels_tall) {
  const Call call("throng_camera_set");
  if (call.is_missing(camera, position, forward, clip_from_world)) return failed;
  auto read = call.read("throng_camera", camera);
  if (!read) return failed;
  write_camera(camera_of(vector_of(position), vector_of(forward), to_mat4(clip_from_world),
                         static_cast<int>(std::min(pixels_tall, std::uint32_t{INT32_MAX}))),
               *read);
  write_known(*read, camera);
  return call.outcome();
}

int throng_camera_include_casters(throng_camera* camera, const float to_light[3], float height) {
  const Call call("throng_camera_include_casters");
  if (call.is_missing(camera, to_light)) return failed;
  auto read = call.read("throng_camera", camera);
  if (!read) return failed;
  Camera own = camera_of_c(*read);
  include_casters(own, vector_of(to_light), height);
  write_camera(own, *read);
  write_known(*read, camera);
  return call.outcome();
}

throng_lod* throng_lod_create(void) { return make<throng_lod>(); }

void throng_lod_free(throng_lod* lod) { delete lod; }

int throng_lod_select(throng_lod* lod, throng_crowd* crowd, const throng_lod_frame* frame,
                      throng_pose_request** requests, uint32_t* count) {
  const Call call("throng_lod_select");
  if (call.is_missing(lod, crowd, frame, requests, count)) return failed;
  lod->requests.clear();
  if (const auto own = read_frame(call, frame)) {
    for (const PoseRequest& request : lod->own.select(crowd->own, *own)) lod->requests.push_back(c_request_of(request));
  }
  *requests = lod->requests.data();
  *count = static_cast<uint32_t>(lod->requests.size());
  return call.outcome();
}

int throng_lod_settle(throng_lod* lod, const throng_crowd* crowd) {
  const Call call("throng_lod_settle");
  if (call.is_missing(lod, crowd)) return failed;
  const std::span<PoseRequest> own = lod->own.requests();
  for (std::size_t i = 0; i < lod->requests.size(); ++i) {  // it learns which agents are drawn
    own[i].palette = reinterpret_cast<std::byte*>(lod->requests[i].palette);
  }
  lod->own.settle(crowd->own);
  return call.outcome();
}

int throng_lod_make_due(throng_lod* lod, throng_id agent) {
  const Call call("throng_lod_make_due");
  if (call.is_missing(lod)) return failed;
  lod->own.make_due(agent_id(agent));
  return call.outcome();
}

int throng_lod_is_visible(const throng_lod* lod, throng_id agent) {
  return !is_missing("throng_lod_is_visible", lod) && lod->own.is_visible(agent_id(agent)) ? 1 : 0;
}
