#pragma once

#include "app/commands/pose/options.h"

namespace throng::app {

/// Runs `throng pose`: writes every skin of the file at every time, in the dump format of the animation oracle: the
/// joints' local t, r, s and global matrix, and joint global * inverse bind. Matrices are 16 numbers, column-major.
/// Returns the exit status; a failure is one line on stderr and touches no file.
int run_pose(const PoseOptions& options);

}  // namespace throng::app
