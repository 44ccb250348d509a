#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "app/settings/settings.h"

namespace throng::app {

// The words for each enumeration of the settings and the report, in its order. The command line has the same words.
inline constexpr std::array<const char*, 6> scene_words = {"plaza", "parade", "stadium", "grid", "film", "tracks"};
inline const char* word_of(Scene scene) { return scene_words.at(static_cast<std::size_t>(scene)); }
inline constexpr std::array<const char*, 2> clothes_words = {"own", "pattern"};
inline constexpr std::array<const char*, 4> weather_words = {"mild", "warm", "cold", "rain"};
inline constexpr std::array<const char*, 3> camera_path_words = {"none", "orbit", "pan"};
inline constexpr std::array<const char*, 2> schedule_words = {"fused", "levels"};
inline constexpr std::array<const char*, 3> double_buffer_words = {"off", "inline", "interleaved"};
inline constexpr std::array<const char*, 4> swept_value_words = {"PUs", "store", "tile", "grain"};
inline constexpr std::array<const char*, 2> stream_words = {"sampled", "keyframe"};
inline constexpr std::array<const char*, 2> palette_words = {"float", "packed"};
inline constexpr std::array<const char*, 3> lod_rule_words = {"off", "distance", "budget"};
inline constexpr std::array<const char*, 3> error_sampling_words = {"some", "all", "off"};
inline constexpr std::array<const char*, 3> split_words = {"off", "exact | LOD", "difference"};
inline constexpr std::array<const char*, 4> posture_words = {"upright", "falls", "lies", "gets up"};
inline constexpr std::array<const char*, 8> debug_view_words = {"none",  "interval", "bones",   "mesh",
                                                                "error", "speed",    "density", "presence"};
inline constexpr std::array<const char*, 6> up_axis_words = {"x", "y", "z", "-x", "-y", "-z"};
inline constexpr std::array<const char*, 3> ground_words = {"guess", "file", "feet"};

// The engine may change its enumerations. These checks fail when their order is no longer the order of the words.
template <std::size_t count, class Choice>
consteval bool is_last(const std::array<const char*, count>& words, Choice choice, std::string_view word) {
  return static_cast<std::size_t>(choice) + 1 == count && words.back() == word;
}
static_assert(is_last(schedule_words, anim::Schedule::levels, "levels"));
static_assert(is_last(double_buffer_words, anim::DoubleBuffering::interleaved, "interleaved"));
static_assert(is_last(stream_words, anim::StreamKind::keyframe, "keyframe"));
static_assert(is_last(palette_words, PaletteFormat::packed, "packed"));
static_assert(is_last(up_axis_words, anim::UpAxis::minus_z, "-z"));
static_assert(is_last(ground_words, anim::GroundRule::feet, "feet"));
static_assert(is_last(lod_rule_words, LodRule::budget, "budget"));

}  // namespace throng::app
