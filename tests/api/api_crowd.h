#pragma once

#include <memory>
#include <string>
#include <vector>

#include "throng/throng.h"

namespace throng::api_test {

/// The built-in character, loaded once.
inline const Character& mannequin() {
  static const Character loaded =
      load(THRONG_SOURCE_DIR "/assets/mannequin.glb", {.keep_meshes = true})->characters.front();
  return loaded;
}

/// Returns the hash of the poses that an agent of a character goes through in a second of a clip.
inline std::uint64_t hash_of(const Character& character, ClipId clip = {1}) {
  Crowd crowd = std::move(*Crowd::create(character, {.hash = true}));
  const PoseRequest request{.agent = crowd.add_agent()};
  crowd.agent(request.agent).play({.clip = clip});
  for (int frame = 0; frame < 30; ++frame) {
    crowd.advance(ticks_per_second / 30);
    crowd.update({&request, 1});
  }
  return crowd.debug().pose_hash();
}

/// A crowd with a palette for each agent.
class ApiCrowd {
 public:
  explicit ApiCrowd(std::uint32_t agents, CrowdOptions options = {})
      : crowd_(std::move(*Crowd::create(mannequin(), with_hash(options)))) {
    crowd_.add_agents(agents);
  }

  Crowd* operator->() { return &crowd_; }
  Crowd& operator*() { return crowd_; }
  Agent agent(std::uint32_t number) { return crowd_.agent({.number = number}); }

  /// Poses all agents, `frames` frames of a 60th of a second.
  void step(int frames = 1) {
    for (int frame = 0; frame < frames; ++frame) {
      crowd_.advance(ticks_per_second / 60);
      list_requests();
      crowd_.update(requests_);
    }
  }
  /// Returns the last palette of an agent, 12 floats an entry.
  const float* palette(AgentId agent) const { return lines_[agent.number * stride_].floats; }
  std::uint64_t hash() const { return crowd_.debug().pose_hash(); }

 private:
  struct alignas(64) Line {
    float floats[16];
  };
  static CrowdOptions with_hash(CrowdOptions options) {
    options.hash = true;
    return options;
  }
  void list_requests() {
    stride_ = crowd_.palette_bytes(0) / sizeof(Line);
    lines_.resize(stride_ * crowd_.number_limit());
    requests_.clear();
    for (const AgentId agent : crowd_.agents()) {
      requests_.push_back(
          {.agent = agent, .palette = reinterpret_cast<std::byte*>(lines_[agent.number * stride_].floats)});
    }
  }

  Crowd crowd_;
  std::size_t stride_ = 0;
  std::vector<Line> lines_;
  std::vector<PoseRequest> requests_;
};

}  // namespace throng::api_test
