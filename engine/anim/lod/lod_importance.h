#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/anim/base/units.h"

namespace throng::anim {

/// Decides which agents may show less error than others. The selected agent may show a quarter of the error. An agent
/// in a fade may show half of it, because its pose moves more than either clip does.
class LodImportance {
 public:
  /// Forgets everything and makes room for `agents`.
  void reset(std::size_t agents);
  /// Notes that the agent goes over to another clip until `until`.
  void fade(std::uint32_t agent, Ticks until);
  /// Finds the importance of all agents. Call it once a frame.
  void weigh(Ticks now, std::optional<std::uint32_t> selected);

  std::span<const float> of_agents() const { return importance_; }      ///< LodFrame::importance
  std::span<const std::uint8_t> changing() const { return changing_; }  ///< LodFrame::changing

 private:
  std::vector<float> importance_;       // [agent]
  std::vector<std::uint8_t> changing_;  // [agent]
  std::vector<Ticks> fades_until_;      // [agent] 0: does not fade
  std::vector<std::uint32_t> fading_;   // agents
  std::optional<std::uint32_t> selected_;
};

}  // namespace throng::anim
