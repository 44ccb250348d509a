#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "app/commands/pose/options.h"
#include "engine/anim/asset/model.h"
#include "engine/anim/base/result.h"

namespace throng::app {

/// One pose of a skeleton, as whatever computed it has it.
struct BonePose {
  std::vector<anim::StateTransform> states;  ///< one a bone, relative to the bind pose (see anim::ReferenceFrame)
  std::vector<glm::dmat4> palette;           ///< one a palette entry, model space
};

/// Computes poses for run_pose.
class PoseSource {
 public:
  PoseSource() = default;
  PoseSource(const PoseSource&) = delete;
  PoseSource& operator=(const PoseSource&) = delete;
  virtual ~PoseSource() = default;

  /// `clip` is one of the model's, or null for the rest pose.
  virtual anim::Result<BonePose> pose(const anim::Model& model, const anim::Clip* clip, double seconds) = 0;
};

/// Straight from the definition, in double: what every other source is measured against.
class ReferencePoseSource final : public PoseSource {
 public:
  anim::Result<BonePose> pose(const anim::Model& model, const anim::Clip* clip, double seconds) override;
};

/// Index among the file's animations of a name or, where none is called so, an index; nothing for "none". The error
/// lists what there is.
anim::Result<std::optional<int>> find_animation(const anim::ImportedFile& file, const std::string& clip);

/// Every skin of the file at every time, in the dump format of the animation oracle: the joints' local t, r, s and
/// global matrix, and joint global * inverse bind. Matrices are 16 numbers, column-major.
anim::Result<std::string> pose_json(const anim::ImportedFile& file, std::optional<int> animation,
                                    const std::vector<double>& times, PoseSource& source);

/// `throng pose`. Returns the exit status; on failure one line has gone to stderr and no file was touched.
int run_pose(const PoseOptions& options, PoseSource& source);
int run_pose(const PoseOptions& options);

}  // namespace throng::app
