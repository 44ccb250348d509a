#include "engine/anim/api/c/parts.h"

namespace throng::c {

static_assert(THRONG_PACE_OWN == static_cast<int>(Pace::own));
static_assert(THRONG_PLANE_SPEED_AND_TURN == static_cast<int>(PlaneMeaning::speed_and_turn));

template <>
throng_play default_of() {
  const Play own;
  throng_play play{};
  play.clip = own.clip.number;
  play.fade = static_cast<float>(to_seconds(own.fade));
  play.speed = static_cast<float>(own.speed);
  play.start = static_cast<float>(to_seconds(own.start));
  play.loop = own.loop ? 1 : 0;
  play.mask = own.mask.number;
  return play;
}

template <>
throng_one_shot default_of() {
  const OneShot own;
  throng_one_shot shot{};
  shot.clip = own.clip.number;
  shot.fade_in = static_cast<float>(to_seconds(own.fade_in));
  shot.fade_out = static_cast<float>(to_seconds(own.fade_out));
  shot.speed = static_cast<float>(own.speed);
  shot.queued = own.queued ? 1 : 0;
  return shot;
}

template <>
throng_layer default_of() {
  const Layer own;
  return {.size = 0, .weight = own.weight, .mask = own.mask.number};
}

template <>
throng_blend_space default_of() {
  const BlendSpace own;
  throng_blend_space space{};
  space.parameter = own.parameter;
  space.is_ground_speed = own.is_ground_speed ? 1 : 0;
  return space;
}

template <>
throng_blend_space_2d default_of() {
  const BlendSpace2d own;
  throng_blend_space_2d space{};
  space.x = own.x;
  space.y = own.y;
  space.meaning = static_cast<uint32_t>(own.meaning);
  return space;
}

namespace {

Play play_of(const throng_play& play) {
  Play own;
  own.clip = {play.clip};
  own.fade = ticks_of(play.fade);
  own.speed = static_cast<double>(play.speed);
  own.start = ticks_of(play.start);
  own.loop = play.loop != 0;
  own.mask = {play.mask};
  if (play.absolute_root != nullptr) own.absolute_root = place_of(*play.absolute_root);
  return own;
}

OneShot shot_of(const throng_one_shot& shot) {
  return {.clip = {shot.clip},
          .fade_in = ticks_of(shot.fade_in),
          .fade_out = ticks_of(shot.fade_out),
          .speed = static_cast<double>(shot.speed),
          .queued = shot.queued != 0};
}

Layer layer_of(const throng_layer& layer) { return {.weight = layer.weight, .mask = {layer.mask}}; }

BlendPoint point_of(const throng_blend_point& point) {
  return {.clip = {point.clip}, .parameter = point.parameter, .pace = static_cast<Pace>(point.pace)};
}
BlendPoint2d point_of(const throng_blend_point_2d& point) {
  return {.clip = {point.clip}, .x = point.x, .y = point.y, .pace = static_cast<Pace>(point.pace)};
}

/// Returns the points of a blend space; nothing, after a report, if they are none.
template <typename Space>
auto points_of(const Call& call, const Space& space) {
  std::optional<std::vector<decltype(point_of(*space.points))>> points;
  if (call.lacks(space.points, space.point_count)) return points;
  points.emplace();
  for (const auto& point : std::span(space.points, space.point_count)) {
    points->push_back(point_of(point));
    if (!call.is_constant("the pace of a point", point.pace, Pace::own)) points.reset();
    if (!points) break;
  }
  return points;
}

/// Calls add(layer) if the layer can be read, and returns the channel.
template <typename Add>
uint32_t add_channel(const Call& call, const throng_layer* layer, const Add& add) {
  const auto read = call.read("throng_layer", layer);
  return read ? number_or_none(add(layer_of(*read))) : THRONG_NONE;
}

}  // namespace
}  // namespace throng::c

using namespace throng::c;  // NOLINT: functions of C have no namespace

int throng_play_fill(throng_play* into, size_t size) { return fill("throng_play_fill", into, size); }
int throng_one_shot_fill(throng_one_shot* into, size_t size) { return fill("throng_one_shot_fill", into, size); }
int throng_layer_fill(throng_layer* into, size_t size) { return fill("throng_layer_fill", into, size); }
int throng_blend_space_fill(throng_blend_space* into, size_t size) {
  return fill("throng_blend_space_fill", into, size);
}
int throng_blend_space_2d_fill(throng_blend_space_2d* into, size_t size) {
  return fill("throng_blend_space_2d_fill", into, size);
}

int throng_agent_play(throng_crowd* crowd, throng_id agent, const throng_play* play) {
  const Call call("throng_agent_play");
  if (call.is_missing(crowd, play)) return failed;
  const auto read = call.read("throng_play", play);
  return read ? call.outcome(agent_of(crowd, agent).play(play_of(*read))) : failed;
}

int throng_agent_play_on(throng_crowd* crowd, throng_id agent, uint32_t channel, const throng_play* play) {
  const Call call("throng_agent_play_on");
  if (call.is_missing(crowd, play)) return failed;
  const auto read = call.read("throng_play", play);
  return read ? call.outcome(agent_of(crowd, agent).play({channel}, play_of(*read))) : failed;
}

int throng_agent_set_speed(throng_crowd* crowd, throng_id agent, float speed) {
  const Call call("throng_agent_set_speed");
  if (call.is_missing(crowd)) return failed;
  return call.outcome(agent_of(crowd, agent).set_speed(static_cast<double>(speed)));
}

uint32_t throng_agent_add_clips(throng_crowd* crowd, throng_id agent, const throng_layer* layer) {
  const Call call("throng_agent_add_clips");
  if (call.is_missing(crowd)) return THRONG_NONE;
  return add_channel(call, layer, [&](const Layer& own) { return agent_of(crowd, agent).add_clips(own); });
}

int throng_agent_set_weight(throng_crowd* crowd, throng_id agent, uint32_t channel, float weight, float fade) {
  const Call call("throng_agent_set_weight");
  if (call.is_missing(crowd)) return failed;
  return call.outcome(agent_of(crowd, agent).set_weight({channel}, weight, ticks_of(fade)));
}

int throng_agent_remove_channel(throng_crowd* crowd, throng_id agent, uint32_t channel) {
  const Call call("throng_agent_remove_channel");
  return call.is_missing(crowd) ? failed : call.outcome(agent_of(crowd, agent).remove(ChannelId{channel}));
}

uint32_t throng_agent_add_blend_space(throng_crowd* crowd, throng_id agent, const throng_blend_space* space,
                                      const throng_layer* layer) {
  const Call call("throng_agent_add_blend_space");
  if (call.is_missing(crowd, space)) return THRONG_NONE;
  const auto read = call.read("throng_blend_space", space);
  const auto points = read ? points_of(call, *read) : std::nullopt;
  if (!points) return THRONG_NONE;
  const BlendSpace own{.points = *points, .parameter = read->parameter, .is_ground_speed = read->is_ground_speed != 0};
  return add_channel(call, layer, [&](const Layer& above) { return agent_of(crowd, agent).add(own, above); });
}

uint32_t throng_agent_add_blend_space_2d(throng_crowd* crowd, throng_id agent, const throng_blend_space_2d* space,
                                         const throng_layer* layer) {
  const Call call("throng_agent_add_blend_space_2d");
  if (call.is_missing(crowd, space)) return THRONG_NONE;
  const auto read = call.read("throng_blend_space_2d", space);
  if (!read || !call.is_constant("throng_blend_space_2d::meaning", read->meaning, PlaneMeaning::speed_and_turn)) {
    return THRONG_NONE;
  }
  const auto points = points_of(call, *read);
  if (!points) return THRONG_NONE;
  const BlendSpace2d own{
      .points = *points, .meaning = static_cast<PlaneMeaning>(read->meaning), .x = read->x, .y = read->y};
  return add_channel(call, layer, [&](const Layer& above) { return agent_of(crowd, agent).add(own, above); });
}

int throng_agent_set_parameter(throng_crowd* crowd, throng_id agent, uint32_t channel, float parameter) {
  const Call call("throng_agent_set_parameter");
  if (call.is_missing(crowd)) return failed;
  return call.outcome(agent_of(crowd, agent).set_parameter({channel}, parameter));
}

int throng_agent_set_parameters(throng_crowd* crowd, throng_id agent, uint32_t channel, float x, float y) {
  const Call call("throng_agent_set_parameters");
  if (call.is_missing(crowd)) return failed;
  return call.outcome(agent_of(crowd, agent).set_parameters({channel}, x, y));
}

uint32_t throng_agent_add_slot(throng_crowd* crowd, throng_id agent, const throng_layer* layer) {
  const Call call("throng_agent_add_slot");
  if (call.is_missing(crowd)) return THRONG_NONE;
  return add_channel(call, layer, [&](const Layer& own) { return agent_of(crowd, agent).add_slot(own); });
}

int throng_agent_play_once(throng_crowd* crowd, throng_id agent, uint32_t slot, const throng_one_shot* shot) {
  const Call call("throng_agent_play_once");
  if (call.is_missing(crowd, shot)) return failed;
  const auto read = call.read("throng_one_shot", shot);
  return read ? call.outcome(agent_of(crowd, agent).play_once({slot}, shot_of(*read))) : failed;
}

int throng_agent_is_playing(const throng_crowd* crowd, throng_id agent, uint32_t slot) {
  const Call call("throng_agent_is_playing");
  if (call.is_missing(crowd)) return 0;
  return call.yes_or_no(agent_of(crowd, agent).is_playing({slot}));
}
