#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <glm/mat4x4.hpp>

#include "throng/render/renderer.h"

#include "app/show/picture.h"
#include "app/show/stage/stage.h"
#include "tests/gl/reference_crowd.h"
#include "tests/gl/skinning_read_back.h"

namespace throng::app::test {

/// Passes a renderer's pages on and remembers their memory, so that a test can write a fault into one.
class RememberedPages final : public render::PalettePageSource {
 public:
  explicit RememberedPages(render::PalettePageSource& source) : source_(&source) {}
  render::PalettePage add_page() override { return pages_.emplace_back(source_->add_page()); }
  render::PalettePage page(std::uint32_t index) const { return pages_[index]; }

 private:
  render::PalettePageSource* source_;
  std::vector<render::PalettePage> pages_;
};

/// A stage that poses the built-in character into a renderer's palette pages, and a reference that knows the right
/// result. The input of the device is public, so that tests can put faults into it.
class StagedCrowd {
 public:
  static constexpr Ticks frame_step = ticks_per_second / 60;

  StagedCrowd(render::gl::Context& context, const Tuning& tuning);

  /// Fences the last frame, then moves the crowd on, poses and composes it.
  void pass_frame();
  void retune(const Tuning& tuning);
  void draw_camera_back(float metres) { camera_.position -= metres * render::forward(camera_); }

  /// Says whether the device shows `agent` strictly between two poses.
  bool blends(std::uint32_t agent) const;
  /// Measures the distance in metres of the device's surface of `agent` from the reference's, at the worst vertex.
  double largest_error(std::uint32_t agent);
  /// Measures the distance in pixels of the device's surface of `agent` from the clips' pose of this moment with all
  /// bones, at the worst vertex in the picture. The stage's error meter should say the same.
  double largest_error_on_screen(std::uint32_t agent);

  /// Makes a fault: passes the right palettes of both slots of `agent` through `change` and writes them again.
  template <typename Change>
  void rewrite_palettes(std::uint32_t agent, const Change& change) {
    const ShownPose& pose = stage_->posed().shown().pose(agent);
    const Slots& moments = moments_[agent];
    write(pose.from, change(reference_->palette(agent, moments.from)));
    write(pose.to, change(reference_->palette(agent, moments.to)));
  }
  /// Makes no fault: writes the packed pose that `agent` blends to again, with the opposite quaternions of the same
  /// rotations.
  void negate_rotations(std::uint32_t agent);
  render::InstanceRecord& record(std::uint32_t agent) { return instances_[instance_of(agent)]; }

  const Stage& stage() const { return *stage_; }
  const ReferenceCrowd& reference() const { return *reference_; }

 private:
  struct Slots {
    PoseMoment from, to;
  };

  void note_moments();
  std::vector<render::test::ReadBackVertex> surface_on_device(std::uint32_t agent);
  std::uint32_t instance_of(std::uint32_t agent) const;
  double blend_of(std::uint32_t agent) const;
  std::vector<glm::dvec3> reference_surface(std::uint32_t agent) const;
  render::CrowdFrame frame() const;
  void write(const PaletteSlot& slot, const std::vector<anim::PaletteMatrix>& palette);

  std::unique_ptr<render::Renderer> renderer_;
  std::unique_ptr<render::test::SkinningReadBack> read_back_;
  std::unique_ptr<RememberedPages> pages_;
  std::unique_ptr<Stage> stage_;
  std::unique_ptr<ReferenceCrowd> reference_;
  render::Camera camera_;
  Picture picture_;
  std::vector<render::InstanceRecord> instances_;
  std::vector<render::AgentLook> looks_;
  std::uint64_t looks_number_ = render::new_looks_number();
  std::vector<Slots> moments_;  // [agent]
};

/// Gives the matrix in the form in which animation writes it.
anim::PaletteMatrix rows_of(const glm::dmat4& matrix);

}  // namespace throng::app::test
