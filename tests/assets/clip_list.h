#pragma once

#include <algorithm>
#include <array>
#include <string>

#include <gtest/gtest.h>

namespace throng::test {

/// The built-in character's clips in the order of its file.
inline constexpr std::array<const char*, 35> clip_list{
    "idle",        "walk",      "cheer",      "wave",       "clap",         "jog",           "run",
    "look around", "turn left", "turn right", "talk",       "sit down",     "sit",           "stand up",
    "stumble",     "walk back", "step left",  "step right", "shuffle",      "step in place", "veer left",
    "veer right",  "phone",     "call",       "drink",      "take picture", "lean",          "sit on step",
    "carry",       "hold up",   "hold phone", "lead",       "led",          "push",          "stick"};

/// The gaits: they travel, loop, and mark where their feet come down.
inline bool is_gait(const std::string& clip) {
  return clip == "walk" || clip == "jog" || clip == "run" || clip == "walk back" || clip.starts_with("step ") ||
         clip.starts_with("veer ") || clip == "shuffle" || clip == "push" || clip == "stick";
}

inline bool plays_once(const std::string& clip) {
  return clip == "sit down" || clip == "stand up" || clip == "stumble";
}

/// Returns a test's name for a clip. It has no spaces, because a test's name may not.
inline std::string spaceless_clip_name(const ::testing::TestParamInfo<const char*>& clip) {
  std::string name = clip.param;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

}  // namespace throng::test
