#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "throng/heap_pages.h"

#include "app/show/stage/stage.h"
#include "engine/anim/rig/limbs.h"

namespace throng::app {

/// Palette memory that can be looked at.
class KeptPages final : public render::PalettePageSource {
 public:
  render::PalettePage add_page() override {
    pages_.push_back(source_.add_page());
    return pages_.back();
  }
  const anim::PaletteMatrix* palette(const PaletteSlot& slot) const {
    const std::byte* const memory = pages_[slot.page].memory + slot.first_line * render::palette_line_bytes;
    return reinterpret_cast<const anim::PaletteMatrix*>(memory);
  }

 private:
  HeapPageSource source_{std::size_t{16} << 20};
  std::vector<render::PalettePage> pages_;
};

/// Where the balls of feet are, taken from the palettes that are drawn. The ball of a foot stays down longest, while
/// the heel comes and goes.
class PosedFeet {
 public:
  static constexpr std::size_t feet = 2;

  explicit PosedFeet(const anim::Skeleton& skeleton) {
    const anim::Limbs limbs = anim::find_limbs(skeleton);
    for (const auto& leg : {limbs.left_leg, limbs.right_leg}) {
      balls_.push_back(anim::joint_place(skeleton, leg.value().tip));
    }
  }

  struct Ball {
    double x = 0.0, z = 0.0;  ///< metres, in the world
    double lift = 0.0;        ///< metres over where it is when the character stands, at scale 1
  };
  /// Returns nothing where the agent has no palette.
  std::optional<Ball> ball(const Stage& stage, const KeptPages& pages, std::uint32_t agent, std::size_t foot) const {
    const ShownPose& shown = stage.posed().shown().pose(agent);
    if (!shown.shown()) return {};
    const anim::JointPlace& place = balls_[foot];
    const glm::dvec3 in_model = transformed(pages.palette(shown.to)[place.entry], place.position);
    const Crowd& crowd = stage.crowd();
    const glm::dvec3 position(crowd.positions()[agent]);
    const auto scale = static_cast<double>(crowd.scales()[agent]);
    const auto cosine = static_cast<double>(crowd.headings()[agent].cosine);
    const auto sine = static_cast<double>(crowd.headings()[agent].sine);
    return Ball{.x = position.x + scale * (cosine * in_model.x + sine * in_model.z),
                .z = position.z + scale * (cosine * in_model.z - sine * in_model.x),
                .lift = in_model.y - place.position.y};
  }

 private:
  static glm::dvec3 transformed(const anim::PaletteMatrix& matrix, const glm::dvec3& point) {
    glm::dvec3 moved(0.0);
    for (int row = 0; row < 3; ++row) {
      const float* m = matrix.rows[row];
      moved[row] = static_cast<double>(m[0]) * point.x + static_cast<double>(m[1]) * point.y +
                   static_cast<double>(m[2]) * point.z + static_cast<double>(m[3]);
    }
    return moved;
  }

  std::vector<anim::JointPlace> balls_;
};

}  // namespace throng::app
