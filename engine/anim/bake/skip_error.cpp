#include "engine/anim/bake/skip_error.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "engine/anim/bake/character.h"
#include "engine/anim/bake/surface.h"

namespace throng::anim {
namespace {

constexpr int frames_a_stretch = SkipError::spans.back() + 1;
constexpr std::size_t most_stretches = 256;  // of all clips together
constexpr double frames_a_second = 60.0;
constexpr float least_metres = 1e-7F;  // smaller errors count as this, so that a power law exists

/// The places of a surface's points in the frames of one stretch: [frame][point].
class Stretch {
 public:
  explicit Stretch(std::size_t points)
      : points_(points), places_(points * static_cast<std::size_t>(frames_a_stretch)) {}

  std::span<glm::dvec3> frame(int index) {
    return std::span(places_).subspan(static_cast<std::size_t>(index) * points_, points_);
  }
  std::span<const glm::dvec3> frame(int index) const {
    return std::span(places_).subspan(static_cast<std::size_t>(index) * points_, points_);
  }

  /// Returns how far a point at `part` of the line from frame `from` to frame `to` is at most from frame `exact`.
  double largest_error(int from, int to, double part, int exact) const {
    double largest = 0.0;
    for (std::size_t point = 0; point < points_; ++point) {
      const glm::dvec3 shown = frame(from)[point] + (frame(to)[point] - frame(from)[point]) * part;
      const glm::dvec3 apart = shown - frame(exact)[point];
      largest = std::max(largest, glm::dot(apart, apart));
    }
    return std::sqrt(largest);
  }

 private:
  std::size_t points_;
  std::vector<glm::dvec3> places_;
};

/// Poses one clip's surface frame by frame.
class MovingSurface {
 public:
  MovingSurface(const Skeleton& skeleton, const SurfaceProxy& proxy, const BakedClip& clip)
      : skeleton_(skeleton), proxy_(proxy), clip_(clip), frames_(skeleton.bones.size()) {}

  void fill(Stretch& stretch, Ticks start) {
    ExactPoses poses(*clip_.keyframe());
    const bool repeats = clip_.loops && clip_.duration > Ticks{};
    for (int index = 0; index < frames_a_stretch; ++index) {
      const Ticks time = start + to_ticks(index / frames_a_second);
      const Ticks within = repeats ? time % clip_.duration : std::min(time, clip_.duration);
      place_points(poses.at(within), stretch.frame(index));
    }
  }

 private:
  void place_points(std::span<const float> pose, std::span<glm::dvec3> places) {
    compute_frames(skeleton_, pose, frames_);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const SurfacePoint& point = proxy_.points[i];
      const BoneFrame& frame = frames_[static_cast<std::size_t>(point.bone)];
      places[i] = frame.origin + frame.axes * point.offset;
    }
  }

  const Skeleton& skeleton_;
  const SurfaceProxy& proxy_;
  const BakedClip& clip_;
  std::vector<BoneFrame> frames_;
};

float percentile_99_of(std::vector<double>& errors) {
  const auto rank = static_cast<std::ptrdiff_t>(static_cast<double>(errors.size() - 1) * 0.99 + 0.5);
  std::ranges::nth_element(errors, errors.begin() + rank);
  return static_cast<float>(errors[static_cast<std::size_t>(rank)]);
}

/// The errors of all frames of a clip that a span leaves out.
struct Errors {
  std::vector<double> blended, held;

  void add(const Stretch& stretch, int span) {
    for (int from = 0; from + span < frames_a_stretch; from += span / 2) {
      for (int frame = 1; frame < span; ++frame) {
        const double part = static_cast<double>(frame) / span;
        blended.push_back(stretch.largest_error(from, from + span, part, from + frame));
        held.push_back(stretch.largest_error(from, from, 0.0, from + frame));
      }
    }
  }
};

SkipError measure(MovingSurface surface, std::size_t points, Ticks duration, std::size_t stretches) {
  std::array<Errors, SkipError::spans.size()> errors;
  Stretch stretch(points);
  for (std::size_t i = 0; i < stretches; ++i) {
    surface.fill(stretch, duration * static_cast<std::int64_t>(i) / static_cast<std::int64_t>(stretches));
    for (std::size_t span = 0; span < errors.size(); ++span) errors[span].add(stretch, SkipError::spans[span]);
  }
  SkipError error;
  for (std::size_t span = 0; span < errors.size(); ++span) {
    error.blended[span] = percentile_99_of(errors[span].blended);
    error.held[span] = percentile_99_of(errors[span].held);
  }
  return error;
}

}  // namespace

float SkipError::metres(float sixtieths, bool smooth) const {
  if (sixtieths <= 1.0F) return 0.0F;
  const auto& measured = smooth ? blended : held;
  std::size_t upper = 1;
  while (upper + 1 < spans.size() && sixtieths > static_cast<float>(spans[upper])) ++upper;
  const float below = std::max(measured[upper - 1], least_metres), above = std::max(measured[upper], least_metres);
  const auto shorter = static_cast<float>(spans[upper - 1]);
  const float octaves = std::log2(sixtieths / shorter);  // each span is twice the one before it
  return below * std::pow(above / below, octaves);
}

SkipError measure_skip_error(const Skeleton& skeleton, const SurfaceProxy& proxy, const BakedClip& clip,
                             std::size_t clips) {
  const std::size_t stretches = std::clamp<std::size_t>(most_stretches / clips, 2, 8);
  return measure(MovingSurface(skeleton, proxy, clip), proxy.points.size(), clip.duration, stretches);
}

}  // namespace throng::anim
