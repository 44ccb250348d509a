#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "assets/mannequin/mesh.h"

namespace throng::wardrobe {

/// Places a thing's own axes: an origin on the man at rest, and three directions of a right-handed frame.
struct Frame {
  glm::dvec3 origin{0};
  glm::dmat3 axes{1};
  [[nodiscard]] glm::dvec3 at(glm::dvec3 own) const { return origin + axes * own; }
  [[nodiscard]] Frame moved(glm::dvec3 own) const { return {at(own), axes}; }
  /// The same place with other axes, given in those of this frame.
  [[nodiscard]] Frame turned(glm::dvec3 x, glm::dvec3 y) const;
};

/// The man's right hand at rest: x to the thumb, y along the fingers, z out of the palm; the origin is in the wrist.
Frame right_hand();

/// Describes the paint of a surface.
struct Coat {
  mannequin::Region region = mannequin::Region::thing;
  glm::dvec3 paint{1};
  double trim = 0;
};

/// Collects solids that follow joints without bending.
class Solids {
 public:
  explicit Solids(const mannequin::Weights& weights) : weights_(weights) {}

  Coat coat;  ///< Of what is added from now on.

  /// A box with rounded edges about the middle of a frame. `taper` is the size of its upper end (+y) over the lower.
  void box(const Frame& frame, glm::dvec3 size, double bevel, glm::dvec2 taper = {1, 1});
  /// Points (radius, height) turned about y, from below up the outside; both ends are closed.
  void turn(const Frame& frame, std::span<const glm::dvec2> outline, std::size_t around);
  /// A round rod through places in a frame; both ends are closed.
  void rod(const Frame& frame, std::span<const glm::dvec3> way, double radius, std::size_t around = 6);
  /// A flat strap through places; `across` is its breadth's direction at each, and it is bound to `weights` there.
  void strap(std::span<const glm::dvec3> way, std::span<const glm::dvec3> across, double breadth, double thickness,
             const std::function<mannequin::Weights(glm::dvec3)>& weights);
  /// A thin cloth with two sides: a grid of places over 0 to 1 in two directions, which may close or end in a point.
  void cloth(const Frame& frame, std::size_t columns, std::size_t rows,
             const std::function<glm::dvec3(double u, double v)>& place);

  [[nodiscard]] mannequin::Skin skin() const { return skin_; }

 private:
  std::size_t add(glm::dvec3 place);
  std::size_t add(glm::dvec3 place, const mannequin::Weights& weights);
  void face(std::vector<std::size_t> corners);

  mannequin::Weights weights_;
  mannequin::Skin skin_;
};

}  // namespace throng::wardrobe
