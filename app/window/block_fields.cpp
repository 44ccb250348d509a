#include "app/window/block_fields.h"

#include <array>
#include <cstdio>
#include <string>

#include "engine/anim/entity/player.h"

namespace throng::app {
namespace {

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3f", value);
  return text.data();
}

template <class Element>
std::string vector_of(const Element* values, int count) {
  std::string words;
  for (int i = 0; i < count; ++i) words += (i == 0 ? "" : ", ") + number(static_cast<double>(values[i]));
  return words;
}

void add_player(const anim::Player& player, std::vector<BlockField>& fields) {
  const double seconds = anim::to_seconds(player.position / anim::fine_ticks_per_tick);
  fields.push_back({"Position", number(seconds) + " s"});
  fields.push_back({"Clip", std::to_string(player.clip)});
  fields.push_back({"Speed", number(player.speed / 65536.0)});
  fields.push_back({"Loops", std::to_string(player.loop_count)});
}

}  // namespace

std::vector<BlockField> block_fields(const anim::AnimationStateHeader& state) {
  const bool resident = state.transforms_offset != 0;
  std::vector<BlockField> fields = {
      {"Type", std::to_string(static_cast<unsigned>(state.type))},
      {"Total size", std::to_string(state.total_size) + " B"},
      {"Transforms at", resident ? "byte " + std::to_string(state.transforms_offset) : "none: transient"},
      {"Bones", std::to_string(state.bone_count)},
      {"Priority", state.priority == anim::highest_priority ? "highest" : std::to_string(state.priority)},
      {"Owner", std::to_string(state.owner)},
      {"Floats a bone", std::to_string(state.components)},
      {"Delta time", number(anim::to_seconds(state.delta_time)) + " s"},
      {"Velocity", vector_of(state.linear_velocity, 3) + " m/s"},
      {"Turning", vector_of(state.angular_velocity, 3) + " rad/s"}};
  if ((state.flags & anim::AnimationStateHeader::has_absolute_root) != 0) {
    fields.push_back({"Absolute root", vector_of(state.absolute_position, 3) + " m"});
  }
  const bool plays = state.type == anim::EntityType::sampled_player || state.type == anim::EntityType::keyframe_player;
  if (plays) add_player(reinterpret_cast<const anim::Player&>(state), fields);
  return fields;
}

}  // namespace throng::app
