#include "app/recording/items.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "engine/anim/asset/skeleton.h"

namespace throng::app {
namespace {

/// Returns the longest frame that options and the clock of a window allow.
anim::Ticks longest_frame() { return anim::to_ticks(most_frame_seconds * static_cast<double>(most_time_scale)); }

glm::vec3 next_vector(NumberReader& numbers) {
  glm::vec3 vector{0.0F};
  for (int axis = 0; axis < 3; ++axis) vector[axis] = numbers.next<float>();
  return vector;
}

bool is_near(float metres) { return std::abs(metres) <= farthest_camera; }
bool is_near(const glm::vec3& vector) { return is_near(vector.x) && is_near(vector.y) && is_near(vector.z); }

bool is_view(const LodView& view) {
  constexpr float pi = 3.14159265F;
  const render::Camera& camera = view.camera;
  const auto is_size = [](int pixels) { return pixels >= 1 && pixels <= most_picture_pixels; };
  return is_near(camera.position) && std::isfinite(camera.yaw) && std::abs(camera.pitch) <= pi / 2.0F &&
         camera.vertical_view > 0.0F && camera.vertical_view < pi && is_size(view.width) && is_size(view.height);
}

std::optional<std::uint32_t> next_agent(NumberReader& numbers) {
  const auto agent = numbers.next<std::uint32_t>();
  return agent == recorded_nobody ? std::nullopt : std::optional(agent);
}

std::optional<RecordedRequest> push(NumberReader& numbers) {
  const auto agent = numbers.next<std::uint32_t>();
  const RecordedPush push{.agent = agent, .direction = next_vector(numbers)};
  return is_near(push.direction) ? std::optional<RecordedRequest>(push) : std::nullopt;
}

std::optional<RecordedRequest> share(NumberReader& numbers) {
  const auto character = numbers.next<std::uint32_t>();
  const RecordedShare share{.character = character, .share = numbers.next<double>()};
  return is_share(share.share) ? std::optional<RecordedRequest>(share) : std::nullopt;
}

RecordedRoles roles(NumberReader& numbers) {
  RecordedRoles roles{.character = numbers.next<std::uint32_t>()};
  for (int& clip : roles.clips) {
    if (numbers.at_end()) break;  // an earlier version knew fewer roles
    clip = numbers.next<std::int32_t>();
  }
  return roles;
}

std::optional<RecordedRequest> hold(NumberReader& numbers) {
  constexpr float longest_clip = 1e6F;  // seconds
  const auto agent = next_agent(numbers);
  const RecordedHold hold{.agent = agent, .seconds = numbers.next<float>()};
  return std::abs(hold.seconds) <= longest_clip ? std::optional<RecordedRequest>(hold) : std::nullopt;
}

std::vector<int> next_shorts(NumberReader& numbers, std::uint32_t count) {
  std::vector<int> values(count);
  std::ranges::generate(values, [&] { return numbers.next<std::uint16_t>(); });
  return values;
}

std::optional<RecordedRequest> bone_order(NumberReader& numbers) {
  RecordedBoneOrder order{.character = numbers.next<std::uint32_t>(), .choice = {}};
  const auto bones = numbers.next<std::uint32_t>();
  const auto levels = numbers.next<std::uint32_t>();
  if (bones > anim::max_bones || levels > anim::max_bone_levels) return {};
  order.choice.bones = next_shorts(numbers, bones);
  order.choice.level_counts = next_shorts(numbers, levels);
  return order;
}

std::optional<RecordedRequest> characters(std::string_view text) {
  RecordedCharacters characters;
  const auto json = parse_json(text);
  if (!json) return {};
  std::optional<std::string> complaint;
  characters.characters = read_characters(json->elements(), complaint);
  const bool of_files = std::ranges::none_of(characters.characters, &std::string::empty, &RecordedCharacter::file);
  return !complaint && of_files ? std::optional<RecordedRequest>(std::move(characters)) : std::nullopt;
}

std::optional<RecordedRequest> rig(std::string_view text) {
  const auto json = parse_json(text);
  if (!json || !json->is_object() || !(*json)["character"].is_whole(0, most_models - 1)) return {};
  auto choices = recorded_rig((*json)["rig"]);
  if (!choices) return {};
  return RecordedRig{static_cast<std::uint32_t>((*json)["character"].get<int>()), std::move(*choices)};
}

std::optional<RecordedRequest> placement(std::string_view text) {
  const auto json = parse_json(text);
  if (!json || !json->is_object() || !(*json)["character"].is_whole(0, most_models - 1)) return {};
  const auto choice = recorded_placement((*json)["placement"]);
  if (!choice) return {};
  return RecordedPlacement{static_cast<std::uint32_t>((*json)["character"].get<int>()), *choice};
}

std::optional<RecordedRequest> rules(std::string_view text) {
  const auto json = parse_json(text);
  if (!json || !json->is_object() || !(*json)["character"].is_whole(0, most_models - 1)) return {};
  return RecordedRules{static_cast<std::uint32_t>((*json)["character"].get<int>()), recorded_rules((*json)["rules"])};
}

std::optional<RecordedRequest> request_of_numbers(RecordKind kind, NumberReader& numbers) {
  switch (kind) {
    case RecordKind::selection:
      return RecordedSelection{next_agent(numbers)};
    case RecordKind::push:
      return push(numbers);
    case RecordKind::roles:
      return roles(numbers);
    case RecordKind::hold:
      return hold(numbers);
    case RecordKind::rewind:
      return RecordedRewind{};
    case RecordKind::bone_order:
      return bone_order(numbers);
    case RecordKind::share:
      return share(numbers);
    default:
      return {};
  }
}

}  // namespace

std::optional<RecordedRequest> read_request(RecordKind kind, std::string_view payload) {
  if (kind == RecordKind::characters) return characters(payload);
  if (kind == RecordKind::rig) return rig(payload);
  if (kind == RecordKind::placement) return placement(payload);
  if (kind == RecordKind::rules) return rules(payload);
  NumberReader numbers(payload);
  auto request = request_of_numbers(kind, numbers);
  return numbers.at_end() ? std::move(request) : std::nullopt;
}

std::optional<RecordedFrame> read_frame(NumberReader& numbers) {
  RecordedFrame frame;
  frame.delta = anim::Ticks{numbers.next<std::int64_t>()};
  frame.view.camera.position = next_vector(numbers);
  frame.view.camera.yaw = numbers.next<float>();
  frame.view.camera.pitch = numbers.next<float>();
  frame.view.camera.vertical_view = numbers.next<float>();
  frame.view.width = static_cast<int>(numbers.next<std::uint32_t>());
  frame.view.height = static_cast<int>(numbers.next<std::uint32_t>());
  frame.pose_hash = numbers.next<std::uint64_t>();
  const bool can_be = frame.delta >= anim::Ticks{} && frame.delta <= longest_frame() && is_view(frame.view);
  return numbers.good() && can_be ? std::optional(frame) : std::nullopt;
}

}  // namespace throng::app
