#pragma once

#include <string>
#include <vector>

#include "app/settings/settings.h"
#include "engine/anim/import/import.h"

namespace throng::app {

/// The options of `throng pose`.
struct PoseOptions {
  std::string model;
  std::vector<std::string> clips_from;  ///< files whose clips are added to the largest model
  import::ImportOptions reading{};
  std::string clip;           ///< a clip's name or index, or "none" for the pose at rest
  std::vector<double> times;  ///< seconds, at least one
  anim::StreamKind stream = anim::StreamKind::sampled;
  const anim::Kernels* kernels = nullptr;  ///< of one SIMD target; null: the best
  std::string json;                        ///< a file, or "-" for standard output
  bool remove_parts = false;               ///< remove remains of killed runs beside the files to write
};

/// Runs `throng pose`: writes every skin of the file at every time, in the dump format of the animation oracle: the
/// joints' local t, r, s and global matrix, and joint global * inverse bind. Matrices are 16 numbers, column-major.
/// Returns the exit status; a failure is one line on stderr and touches no file.
int run_pose(const PoseOptions& options);

}  // namespace throng::app
