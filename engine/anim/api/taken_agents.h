#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "throng/camera.h"
#include "throng/crowd.h"
#include "throng/lod_rules.h"
#include "throng/ticks.h"

#include "engine/anim/lod/level_of_detail.h"

namespace throng::detail {

/// What a host says of a frame. The spans have an element for each agent, by its number.
struct SaidAgents {
  std::span<const Vec3> positions;
  std::span<const float> scales;  ///< empty: all 1
};

/// Returns why a frame cannot be decided, in one sentence; null if it can. There are agents with numbers below
/// `numbers`.
const char* fault_of(const SaidAgents& said, std::size_t numbers);
const char* fault_of(const Camera& camera);
const char* fault_of(const LodRules& rules);
const char* fault_of_step(Ticks step);

/// Copies what a host says of the agents of a crowd, by number, for level of detail. There is room for numbers to come:
/// those without an agent are absent.
class TakenAgents {
 public:
  /// Makes room. Returns whether there is more than before; then all that is kept by number has to be made anew.
  bool make_room(std::size_t numbers);
  std::size_t room() const { return positions_.size(); }

  /// Copies. An agent whose position or scale is no number is absent, and a misuse of `call` is reported.
  void take(const Crowd& crowd, const SaidAgents& said, const char* call);

  /// Returns the agents as they were taken last.
  anim::LodCrowd agents() const {
    return {
        .positions = positions_, .scales = scales_, .character_of = characters_, .clips = clips_, .absent = is_absent_};
  }
  /// Makes the agents due that came, or were asked for clips, since agents were taken before. An agent that goes over
  /// to another clip may show less error until then.
  void tell(const Crowd& crowd, anim::LevelOfDetail& lod) const;

 private:
  std::vector<glm::vec3> positions_;  // [number, up to the room]
  std::vector<float> scales_;
  std::vector<std::uint8_t> characters_;
  std::vector<int> clips_;
  std::vector<std::uint8_t> is_absent_;
  std::vector<std::uint32_t> generations_;  // [number] of the agent that was seen last
  std::vector<std::uint32_t> requests_;     // [number] AgentNotes::requests
  std::vector<std::uint32_t> newcomers_, asked_;
};

}  // namespace throng::detail
