#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "engine/anim/asset/keyframe_stream.h"
#include "engine/anim/asset/model.h"
#include "engine/anim/asset/sampled_stream.h"
#include "engine/anim/kernel/keyframe/keyframe_player.h"
#include "engine/anim/survey/model_extent.h"

namespace throng::anim {

/// The place of a bone in model space: it carries a point at `offset` to origin + axes * offset.
struct BoneFrame {
  glm::dmat3 axes{1.0};
  glm::dvec3 origin{0.0};
};

/// Computes the hierarchy of one pose in double. `pose` is float [packet][component][16], `frames` one a bone.
void compute_frames(const Skeleton& skeleton, std::span<const float> pose, std::span<BoneFrame> frames);

/// A point that stands for the surface around it.
struct SurfacePoint {
  int bone = 0;
  glm::dvec3 offset{0.0};  ///< in the bone's axes
};

/// The points on which errors are measured: every joint, and for each bone the farthest vertex skinned mainly to it.
struct SurfaceProxy {
  std::vector<SurfacePoint> points;
  double height = 0.0;  ///< metres, of the rest pose's surface, or of its joints where there is no surface; > 0
};
SurfaceProxy make_surface_proxy(const Model& model);

/// Returns the largest distance that any point of the proxy has between two poses.
double largest_distance(const SurfaceProxy& proxy, std::span<const BoneFrame> from, std::span<const BoneFrame> to);

/// Poses a keyframe stream, one time after the other.
class ExactPoses {
 public:
  explicit ExactPoses(const KeyframeStream& stream);
  /// Returns the whole pose at `time`, valid until the next call.
  std::span<float> at(Ticks time);

 private:
  const KeyframeStream& stream_;
  KeyframeCursor cursor_;
  AlignedBytes interpolations_;
  AlignedBytes pose_;
};

/// Poses a sampled stream.
class SampledPoses {
 public:
  explicit SampledPoses(const SampledStream& stream);
  /// Returns the whole pose between two rows, valid until the next call.
  std::span<const float> at(const SamplePoint& point);

 private:
  const SampledStream& stream_;
  AlignedBytes pose_;
};

/// Poses a clip, one time after the other: from its keys where it keeps them, else from its rows. One is not null.
class ClipPoses {
 public:
  ClipPoses(const KeyframeStream* keys, const SampledStream* rows);
  /// Returns the whole pose at `time`, valid until the next call.
  std::span<const float> at(Ticks time) { return keys_ ? keys_->at(time) : rows_->at(locate(*stream_, time)); }

 private:
  std::optional<ExactPoses> keys_;
  std::optional<SampledPoses> rows_;
  const SampledStream* stream_;
};

}  // namespace throng::anim
