#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include <glm/vec2.hpp>

#include "throng/render/camera.h"

#include "app/people/measure/crowd_measures.h"
#include "app/settings/settings.h"
#include "app/show/stage/animated_crowd.h"
#include "app/show/stage/kept_joints.h"
#include "app/show/stage/stage_times.h"
#include "engine/crowd/system_view.h"

namespace throng::app {

/// Tells the milliseconds since the last question, or since it was made.
class StopWatch {
 public:
  double lap() {
    const auto before = std::exchange(since_, std::chrono::steady_clock::now());
    return std::chrono::duration<double, std::milli>(since_ - before).count();
  }

 private:
  std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
};

/// How a frame is seen.
struct SeenFrame {
  render::Camera camera;
  glm::vec2 size{0.0F};                   ///< of the picture, pixels
  Ticks step{};                           ///< time of one frame, for looking ahead
  bool moves = true;                      ///< time passes
  std::optional<std::uint32_t> selected;  ///< the agent that is looked at
  std::uint64_t completed = 0;            ///< the newest frame that the device has finished reading
};

/// Shows the crowd of a stage. The demo sets the parts of a pose beyond clips, keeps joints and measures the crowd.
class PosedCrowd : public SystemView {
 public:
  /// Asks `pages` for no page before the first pose. Counts frames on from `first_frame`. `characters` outlive this.
  PosedCrowd(std::span<const CharacterSource> characters, render::PalettePageSource& pages, std::uint64_t first_frame);

  /// Poses a frame, step by step. `times` gets the milliseconds of its parts.
  void pose(AnimatedCrowd& animated, const SeenFrame& seen, const Tuning& tuning, StageTimes& times);

  /// Keeps the joints of all poses from now on, for joints(). Errors: those of KeptJoints::begin.
  Status keep_joints(anim::AnimationSystem& system) { return joints_.begin(system, characters_); }
  const KeptJoints& joints() const { return joints_; }
  const CrowdMeasures& measures() const { return measures_; }

 private:
  struct Frame;

  Camera seen_by(const SeenFrame& seen, const render::CameraView& view, const Tuning& tuning) const;
  SystemFrame view_frame(const AnimatedCrowd& animated, const SeenFrame& seen, const Tuning& tuning) const;
  void prepare(const Frame& frame, std::span<PoseRequest> updates);
  void place_feet(const Frame& frame, const PoseRequest& update, bool near_by) const;
  void add_fallen(const Frame& frame);

  std::span<const CharacterSource> characters_;
  KeptJoints joints_;
  CrowdMeasures measures_;
};

}  // namespace throng::app
