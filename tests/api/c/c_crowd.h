#pragma once

#include <string>
#include <vector>

#include "throng/c.h"

#include "tests/api/api_crowd.h"

namespace throng::api_test {

inline constexpr throng_id first_character{0, THRONG_NONE};

/// Hears of the misuses of C that a test makes on purpose, as long as it lives: a build with assertions would end at
/// them. The library for C has a hook of its own, which anim::HeardMisuses does not set.
class CMisuses {
 public:
  CMisuses() {
    throng_set_misuse_hook([](const char* call, const char*,
                              void* user) { static_cast<std::vector<std::string>*>(user)->emplace_back(call); },
                           &heard);
  }
  ~CMisuses() { throng_set_misuse_hook(nullptr, nullptr); }
  CMisuses(const CMisuses&) = delete;
  CMisuses& operator=(const CMisuses&) = delete;

  std::vector<std::string> heard;  ///< the names of misused calls
};

/// A crowd of the built-in character, made through C. It hears of the misuses that a test makes on purpose.
class CCrowd : public CMisuses {
 public:
  explicit CCrowd(std::uint32_t agents, throng_crowd_options options = throng_crowd_options_default()) : ids(agents) {
    throng_load_options kept = throng_load_options_default();
    kept.keep_meshes = 1;
    throng_file* const file = throng_load_with(THRONG_SOURCE_DIR "/assets/mannequin.glb", &kept);
    character = throng_file_character(file, 0);
    throng_file_free(file);
    options.hash = 1;
    crowd = throng_crowd_create(character, &options);
    throng_crowd_add_agents(crowd, first_character, agents, ids.data());
  }
  ~CCrowd() {
    throng_crowd_free(crowd);
    throng_character_free(character);
  }
  CCrowd(const CCrowd&) = delete;
  CCrowd& operator=(const CCrowd&) = delete;

  std::uint32_t clip(const char* name) const { return throng_character_find_clip(character, name); }
  std::uint32_t bone(const char* name) const { return throng_character_find_bone(character, name); }
  int play(std::uint32_t agent, std::uint32_t clip) const {
    throng_play play = throng_play_default();
    play.clip = clip;
    return throng_agent_play(crowd, ids[agent], &play);
  }
  void step(int frames = 1) const {
    std::vector<throng_pose_request> requests;
    for (const throng_id id : ids) {
      throng_pose_request request{};
      request.agent = id;
      requests.push_back(request);
    }
    for (int frame = 0; frame < frames; ++frame) {
      throng_crowd_advance(crowd, 1.0 / 60.0);
      throng_crowd_update(crowd, requests.data(), static_cast<std::uint32_t>(requests.size()));
    }
  }
  std::uint64_t hash() const { return throng_crowd_pose_hash(crowd); }

  throng_character* character = nullptr;
  throng_crowd* crowd = nullptr;
  std::vector<throng_id> ids;
};

/// Returns why a call failed; "" if it went well.
inline std::string why(bool has_failed) { return has_failed ? throng_last_error() : ""; }

}  // namespace throng::api_test
